## r = gs.linear.run_derivatives (m, r, carried, S, lost, held, given, moved)
## The result R of a run of M with the derivatives that it carried (gs.linear.carried_columns):
## structs dx, dy and dv by the names of what they are by, a row for each time.  S: the columns at
## all times; LOST: of each one why there is none from some event on (0: there is), which event,
## when: NaN from there on, and stats.lost, a struct array with name, time, event and text.  HELD:
## the derivatives of the inputs that sampled devices hold, a column from each time on: time, inputs
## by columns.  GIVEN: those of the inputs that follow a planned motion or feedback, a column for
## each time, or none.
## MOVED: those of the times of the events, a column for each: r.events.dt, a struct by the names.

function r = run_derivatives (m, r, carried, S, lost, held, given, moved)
  d = m.sizes;
  n = numel (r.t);
  S = reshape (S, d.nx, numel (carried.names), n);
  for k = find (lost(:,1))'
    S(:,k,r.t >= lost(k,3)) = NaN;
  endfor
  V = inputs (m, r, numel (carried.names), held, given);
  Y = outputs (m, r, carried, S, V);
  r.dx = r.dy = r.dv = struct ();
  for k = 1:numel (carried.names)
    r.dx.(carried.names{k}) = reshape (S(:,k,:), d.nx, n)';
    r.dy.(carried.names{k}) = reshape (Y(:,k,:), d.ny, n)';
    V(:,k,isnan (S(1,k,:))) = NaN;
    r.dv.(carried.names{k}) = reshape (V(:,k,:), d.nv, n)';
  endfor
  r.stats.lost = lost_ones (m, carried.names, lost);
  if (! isempty (m.events))
    r.events.dt = event_times (r.events, carried.names, moved, lost);
  endif
endfunction

## derivatives of the times of the events, a struct by the names
function dt = event_times (events, names, moved, lost)
  dt = struct ();
  for k = 1:numel (names)
    dt.(names{k}) = moved(k,:)';
    if (lost(k,1))
      dt.(names{k})(events.t >= lost(k,3)) = NaN;
    endif
  endfor
endfunction

## the columns that were given up
function list = lost_ones (m, names, lost)
  why = {"the motion only grazes there", ...
         "another event at the same instant would come at another time", ...
         "the equations there have no derivatives", ...
         "what it resets is moved onto the constraints of a loop, which leave a choice"};
  list = struct ("name", {}, "time", {}, "event", {}, "text", {});
  for k = find (lost(:,1))'
    list(end+1) = struct ("name", names{k}, "time", lost(k,3), ...
                          "event", m.events(lost(k,2)).name, "text", why{lost(k,1)});
  endfor
endfunction

## derivatives of the inputs, by columns and times
function V = inputs (m, r, nc, held, given)
  V = zeros (m.sizes.nv, nc, numel (r.t));
  if (! isempty (given))
    V = reshape (given, size (V));
  endif
  for i = 1:numel (r.t)
    k = find (held(1,:) < r.t(i) - 1e-12 * abs (r.t(i)) | i == 1 & held(1,:) <= r.t(i), 1, "last");
    if (! isempty (k))
      V(:,:,i) += reshape (held(2:end,k), m.sizes.nv, nc);
    endif
  endfor
endfunction

## dy = C*S + D*V + what the parameters do by themselves; NaN where that is not emitted
function Y = outputs (m, r, carried, S, V)
  d = m.sizes;
  Y = NaN (d.ny, columns (S), numel (r.t));
  if (d.ny == 0 || ! all (ismember ({"oup", "jac"}, m.subroutines)))
    return;
  endif
  t = gs.run.row_times (m, r.t);
  for i = 1:numel (t)
    x = r.x(i,:)';
    v = r.v(i,:)';
    [~, ~, C, D, bad] = m.jac (t(i), x, v);
    [P, worse] = m.oup (t(i), x, v);
    if (bad > 0 || worse > 0)
      continue;
    endif
    P = [zeros(d.ny, 1), P];
    Y(:,:,i) = C * S(:,:,i) + P(:,1+carried.columns);
    if (d.nv > 0)
      Y(:,:,i) += D * V(:,:,i);
    endif
  endfor
endfunction
