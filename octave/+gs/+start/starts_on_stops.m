## gs.start.starts_on_stops (who, p, x)
## An error where the run P (gs.run.plan_run), which carries derivatives, starts at rest on a stop
## (variant event) that moves with one of its parameters while the start does not: the run of
## another parameter would begin beside the stop, or beyond it.  X: the start with its derivatives
## behind it.

function starts_on_stops (who, p, x)
  [m, t, names, sizes] = deal (p.m, p.times(1), p.carried.names, p.carried.sizes);
  S = reshape (x(m.sizes.nx+1:end), m.sizes.nx, []);
  x = x(1:m.sizes.nx);
  for port = find (strcmp ({m.events.kind}, "stop"))
    for side = 1:2
      [gap, rate] = gap_of (m, t, x, port, side);
      if (abs (gap) > 1e-9 || rate > 1e-9)
        continue;
      endif
      for k = 1:numel (names)
        step = 1e-6 * sizes(k);
        other = m;
        if (isfield (m.par, names{k}))
          other = gsmbp_set (m, names{k}, m.par.(names{k}) + step);
        endif
        slope = (gap_of (other, t, x + step * S(:,k), port, side) - gap) / step;
        if (abs (slope) * sizes(k) > 1e-6)
          error (["%s: option sensitivity: the run starts on the stop %s, whose place changes " ...
                  "by %s otherwise than the start: give \"dx0\" so that they stay together"], ...
                 who, m.events(port).name, names{k});
        endif
      endfor
    endfor
  endfor
endfunction

## how far the port is from its lower (1) or upper (2) end, and how fast that grows
function [gap, rate] = gap_of (m, t, x, port, side)
  [~, place, speed, ends] = m.hld (t, x, zeros (m.sizes.nv, 1));
  way = 3 - 2 * side;
  gap = way * (place(port) - ends(side,port));
  rate = way * speed(port);
endfunction
