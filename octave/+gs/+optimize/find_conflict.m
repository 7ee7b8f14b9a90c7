## [least, near, bounds] = gs.optimize.find_conflict (who, P, q, o)
## Of a design that cannot be: a least set of demands that contradict each other (their numbers):
## without any one of them the others can be met.  NEAR: the values that miss them by least (elastic
## relaxation); BOUNDS: texts of the free variables that are at a bound there.

function [least, near, bounds] = find_conflict (who, P, q, o)
  all_ = 1:numel (P.demands);
  [near, miss] = relaxed (who, P, q, o, all_, q.z0);
  wanted = all_(miss > 1e-7);
  ## those that can be met by themselves are not among them; then one after the other is left out
  least = all_;
  start = near;
  for k = fliplr ([wanted, setdiff(all_, wanted)])
    rest = setdiff (least, k);
    if (isempty (rest))
      break;
    endif
    [z, miss] = relaxed (who, P, q, o, rest, start);
    if (max (miss) > 1e-7)
      least = rest;
      start = z;
    endif
  endfor
  [near, ~] = relaxed (who, P, q, o, least, near);
  bounds = {};
  for i = 1:numel (P.free)
    f = P.free(i);
    if (abs (near(i) - q.low(i)) <= 1e-6 * max (1, abs (q.low(i))))
      bounds{end+1} = sprintf ("%s >= %g", f.name, f.low);
    elseif (abs (near(i) - q.high(i)) <= 1e-6 * max (1, abs (q.high(i))))
      bounds{end+1} = sprintf ("%s <= %g", f.name, f.high);
    endif
  endfor
endfunction

## the values that miss the demands K by least, each beside its size, and by how much
function [z, miss] = relaxed (who, P, q, o, k, z0)
  n = numel (P.free);
  ns = numel (k);
  P.goal = P.goal([]);
  P.demands = P.demands(k);
  P.used = used (P);
  z = z0(1:n);
  e = gs.optimize.assess_values (P, z);
  size_ = max ([max(abs (e.A), [], 2), abs(bounded (e.low)), abs(bounded (e.high))], [], 2);
  size_(size_ == 0) = 1;
  best = missed (e, ns, size_);
  q.newton = false;
  q.f = @(z) elastic (P, z, n, ns, size_);
  q.low = [q.low(1:n); zeros(ns, 1)];
  q.high = [q.high(1:n); Inf(ns, 1)];
  o.evaluations = min (o.evaluations, 300);
  o.tolerance = 1e-8;
  for solver = {"ipopt", "slsqp"}
    if (sum (best) <= 1e-7)
      break;
    endif
    q.z0 = [z; 1.01 * best(:) + 1e-3];
    o.solver = solver{1};
    try
      r = gs.optimize.solve_nlp (who, P.base, q, o);
    catch err
      if (! any (strfind (err.message, "not installed")))
        rethrow (err);
      endif
      continue;
    end_try_catch
    if (! isempty (r.stopped))
      error ("gsmbp:stopped", ["%s: %s while it was looked for the least set of demands that " ...
                               "contradict each other"], who, gs.run.stopped_text (r.stopped));
    endif
    here = missed (gs.optimize.assess_values (P, r.z(1:n)), ns, size_);
    if (sum (here) < sum (best))
      best = here;
      z = r.z(1:n);
    endif
  endfor
  miss = zeros (1, max (k));
  miss(k) = best;
endfunction

## the load cases that the demands read
function k = used (P)
  k = unique ([P.demands(! ismember ({P.demands.word}, {"value", "mass"})).cases]);
  if (any (! cellfun (@isempty, {P.demands.f})))
    k = 1:numel (P.cases);
  endif
endfunction

## by how much each demand is missed
function s = missed (e, ns, size_)
  off = max (0, max (e.low - e.g, e.g - e.high) ./ size_);
  s = arrayfun (@(i) max ([0; off(e.row == i)]), 1:ns);
endfunction

function x = bounded (x)
  x(! isfinite (x)) = 0;
endfunction

## the sum of what the demands are loosened by
function e = elastic (P, z, n, ns, size_)
  a = gs.optimize.assess_values (P, z(1:n));
  S = full (sparse (1:numel (a.row), a.row, size_, numel (a.row), ns));
  s = S * z(n+1:end);
  up = isfinite (a.high);
  down = isfinite (a.low);
  A = a.A(:,1:n);
  e = a;
  e.g = [(a.g - s)(up); (a.g + s)(down)];
  e.A = [A(up,:), -S(up,:); A(down,:), S(down,:)];
  e.low = [-Inf(sum (up), 1); a.low(down)];
  e.high = [a.high(up); Inf(sum (down), 1)];
  e.J = sum (z(n+1:end));
  e.gJ = [zeros(n, 1); ones(ns, 1)];
endfunction
