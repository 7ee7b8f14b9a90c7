## r = gsmbp__derivatives (m, r, carried, S, lost, held, o)
## The result R of a run of M with the derivatives that it carried (gsmbp__carried): structs dx and
## dy by the names of what they are by, a row for each time.  S: the columns at all times; LOST: of
## each one why there is none from some event on (0: there is), which event, when: NaN from there
## on, and stats.lost, a struct array with name, time, event and text.  HELD: the derivatives of the
## inputs that sampled devices hold, a column from each time on: time, inputs by columns.  O: the
## options of the run.

function r = gsmbp__derivatives (m, r, carried, S, lost, held, o)
  d = m.sizes;
  n = numel (r.t);
  S = reshape (S, d.nx, numel (carried.names), n);
  for k = find (lost(:,1))'
    S(:,k,r.t >= lost(k,3)) = NaN;
  endfor
  Y = outputs (m, r, carried, S, held, o);
  r.dx = r.dy = struct ();
  for k = 1:numel (carried.names)
    r.dx.(carried.names{k}) = reshape (S(:,k,:), d.nx, n)';
    r.dy.(carried.names{k}) = reshape (Y(:,k,:), d.ny, n)';
  endfor
  r.stats.lost = lost_ones (m, carried.names, lost);
endfunction

## the columns that were given up
function list = lost_ones (m, names, lost)
  why = {"the motion only grazes there", ...
         "another event at the same instant would come at another time", ...
         "the equations there have no derivatives"};
  list = struct ("name", {}, "time", {}, "event", {}, "text", {});
  for k = find (lost(:,1))'
    list(end+1) = struct ("name", names{k}, "time", lost(k,3), ...
                          "event", m.events(lost(k,2)).name, "text", why{lost(k,1)});
  endfor
endfunction

## dy = C*S + what the parameters do by themselves; NaN where that is not emitted
function Y = outputs (m, r, carried, S, held, o)
  d = m.sizes;
  Y = NaN (d.ny, columns (S), numel (r.t));
  if (d.ny == 0 || ! all (ismember ({"oup", "jac"}, m.subroutines)))
    return;
  endif
  for i = 1:numel (r.t)
    x = r.x(i,:)';
    v = r.v(i,:)';
    [~, ~, C, D, bad] = m.jac (r.t(i), x, v);
    [P, worse] = m.oup (r.t(i), x, v);
    if (bad > 0 || worse > 0)
      continue;
    endif
    P = [zeros(d.ny, 1), P];
    Y(:,:,i) = C * S(:,:,i) + P(:,1+carried.columns);
    k = find (held(1,:) < r.t(i) - 1e-12 * abs (r.t(i)) | i == 1 & held(1,:) <= r.t(i), 1, "last");
    if (! isempty (k))
      Y(:,:,i) += D * reshape (held(2:end,k), d.nv, columns (S));
    endif
    if (! isempty (o.gain))
      Y(:,:,i) -= D * (feedback (m, o, r.t(i), v) * S(:,:,i));
    endif
  endfor
endfunction

## the gain at a time, from the left; 0 for inputs at their limits and those that are not its own
function K = feedback (m, o, t, v)
  K = o.gain;
  if (isstruct (K))
    K = reshape (ppval (K, t - 1e-12 * max (1, abs (t))), m.sizes.nv, m.sizes.nx);
  endif
  if (! isempty (o.bounds))
    bounds = reshape (o.bounds, [], 2);
    K(v <= bounds(:,1) | v >= bounds(:,2),:) = 0;
  endif
  K([vertcat(m.controllers.outputs); vertcat(m.events.input)],:) = 0;
endfunction
