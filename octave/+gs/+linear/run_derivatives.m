## r = gs.linear.run_derivatives (m, r, names, found)
## The result R of a run of M with the derivatives that it carried, FOUND by the module: structs dx,
## dv and dy by the NAMES of what they are by, a row for each time; r.events.dt, of the times of the
## events; stats.lost, a struct array with name, time, event and text of those that were given up,
## which are NaN from there on.

function r = run_derivatives (m, r, names, found)
  [n, nx, nt] = deal (numel (names), m.sizes.nx, found.rows);
  part = @(a, k) a((k-1)*rows (a)/n+1:k*rows (a)/n,:)';
  [r.dx, r.dv, r.dy] = deal (struct ());
  for k = 1:n
    r.dx.(names{k}) = part (found.x(nx+1:end,1:nt), k);
    r.dv.(names{k}) = part (found.dv, k);
    r.dy.(names{k}) = part (found.dy, k);
    if (! isempty (m.events))
      r.events.dt.(names{k}) = found.moved(k,:)';
    endif
  endfor
  r.stats.lost = struct ("name", {}, "time", {}, "event", {}, "text", {});
  for k = find (found.lost(:,1))'
    r.stats.lost(end+1) = struct ("name", names{k}, "time", found.lost(k,3), "event", ...
                                  m.events(found.lost(k,2)).name, "text", found.why{k});
  endfor
endfunction
