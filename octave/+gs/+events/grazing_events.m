## lost = gs.events.grazing_events (m, r, lost, turns, run, atol)
## Events that a run R with derivatives just misses, or grazes without being seen: TURNS, a column
## for each place where an event function comes close to 0 and turns (its number, the time), is
## looked at in a run of the states alone, RUN (times), by a parabola through three states there.
## These are 1e-4 s apart, less where an event is nearer: beyond one the parabola says nothing.
## Where the function's lowest value is within ten times what the tolerances ATOL make of it, or
## that run has an event that R has not, there are no derivatives from there on: LOST as
## gs.linear.run_derivatives has it.

function lost = grazing_events (m, r, lost, turns, run, atol)
  d = 1e-4;
  turns = turns(:,turns(2,:) > r.t(1) + d & turns(2,:) < r.t(end) - d);
  if (isempty (turns))
    return;
  endif
  [~, order] = sort (turns(2,:));
  turns = turns(:,order);
  steps = arrayfun (@(t) min (d, max (1e-9, 0.4 * min ([Inf; abs(t - r.events.t)]))), turns(2,:));
  times = unique ([r.t(1); r.t(end); (ones (3, 1) * turns(2,:) + [-1; 0; 1] * steps)(:)]);
  q = run (times');
  found = unseen (changing (m, r.events), changing (m, q.events), 10 * d);
  for turn = [turns; steps]
    [~, k] = ismember (turn(2) + turn(3) * [-1, 0, 1], times);
    g = arrayfun (@(i) value (m, q, i, turn(1)), k);
    g *= 1 - 2 * (g(1) < 0 && g(3) < 0);   # one of the user that does not rise above 0
    bend = g(1) - 2 * g(2) + g(3);
    low = g(2) - (g(3) - g(1)) ^ 2 / (8 * bend);
    lowest = turn(2) + turn(3) * (g(1) - g(3)) / (2 * bend);
    beyond = any ((r.events.t - turn(2)) .* (r.events.t - lowest) < 0);
    if (turn(2) < found(2) && bend > 0 && ! beyond ...
          && low <= 10 * size_of (m, q, k(2), turn(1), atol))
      found = turn(1:2)';
    endif
  endfor
  if (isfinite (found(2)))
    later = ! lost(:,1) | lost(:,3) > found(2);
    lost(later,:) = ones (sum (later), 1) * [1, found];
  endif
endfunction

## time and number of the events that change what follows
function e = changing (m, e)
  changing = gs.events.changing_events (m);
  is = changing(e.number);
  e = struct ("t", e.t(is), "number", e.number(is));
endfunction

## number and time of the first event that one of two runs has and the other has not
function found = unseen (a, b, near)
  found = [0, Inf];
  n = min (numel (a.t), numel (b.t));
  k = find (a.number(1:n) != b.number(1:n) | abs (a.t(1:n) - b.t(1:n)) > near, 1);
  if (isempty (k))
    k = n + 1;
  endif
  for e = [a, b]
    if (k <= numel (e.t) && e.t(k) < found(2))
      found = [e.number(k), e.t(k)];
    endif
  endfor
endfunction

function modes = modes_of (m, q, i)
  inputs = [m.events.input];   # events of the user have none
  modes = zeros (numel (inputs), 1);
  modes(inputs > 0) = q.v(i,inputs(inputs > 0));
endfunction

function g = value (m, q, i, number)
  g = m.evt (q.t(i), q.x(i,:)', q.v(i,:)', modes_of (m, q, i))(number);
endfunction

function s = size_of (m, q, i, number, atol)
  g = m.evp (q.t(i), q.x(i,:)', q.v(i,:)', modes_of (m, q, i), number);
  s = abs (g(1:m.sizes.nx))' * atol(1:m.sizes.nx);
endfunction
