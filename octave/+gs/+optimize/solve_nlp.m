## r = gs.optimize.solve_nlp (who, m, q, o)
## A small dense problem of the model M by NLopt or Ipopt: Q has z0, low, high and f (z), which
## gives J, gJ; g, A, low, high (constraints low <= g <= high) and H (the Hessian, where Q.newton).
## O: solver, tolerance, iterations, evaluations, seconds.  R: z, e (what f gives there), violation
## (beside the sizes of the constraints), evaluations, iterations, ended, limit, trouble (the last
## error of f), stopped ("", "interrupted" by Ctrl-C, or "timeout" at O.ends: z is then the best so
## far).

function r = solve_nlp (who, m, q, o)
  memory = memory_of (@(z) loosened (q.f(z)), o);
  o.seconds = max (1e-3, min (o.seconds, o.ends - time ()));
  e = memory (q.z0, false);
  nothing_yet (who, memory ("stopped"), e);
  size_J = max ([abs(e.J); abs(e.gJ); 1e-12]);
  size_g = sizes (e);
  if (strcmp (o.solver, "ipopt"))
    r = by_ipopt (who, m, q, o, memory, e, size_J, size_g);
  else
    r = by_nlopt (who, q, o, memory, e, size_J, size_g);
  endif
  late = r.limit && time () >= o.ends;
  r.z = min (max (r.z(:), q.low), q.high);
  [r.e, r.evaluations, r.trouble] = memory (r.z, false);
  [r.stopped, best] = memory ("stopped");
  if (late && isempty (r.stopped))
    r.stopped = "timeout";
  endif
  if (! isempty (r.stopped))
    [r.z, r.e] = deal (best, memory ("best"));
    r.ended = gs.run.stopped_text (r.stopped);
    r.limit = true;
  endif
  r.size_g = size_g;
  r.size_J = size_J;
  r.violation = violation (r.e, size_g);
endfunction

function nothing_yet (who, stopped, e)
  if (isempty (e))
    error ("gsmbp:stopped", "%s: %s before the first values were there", who, ...
           gs.run.stopped_text (stopped));
  endif
endfunction

function s = sizes (e)
  finite = [e.low, e.high];
  finite(! isfinite (finite)) = 0;
  s = max ([max(abs (e.A), [], 2), max(abs (finite), [], 2)], [], 2);
  s(s < 1e-12) = 1;
endfunction

## as many equations as unknowns or more: they may depend on each other, and get some room
function e = loosened (e)
  k = e.low == e.high;
  if (sum (k) >= columns (e.A))
    room = 1e-9 * sizes (e)(k);
    e.low(k) -= room;
    e.high(k) += room;
  endif
endfunction

function v = violation (e, size_g)
  v = max ([0; (e.low - e.g) ./ size_g; (e.g - e.high) ./ size_g]);
endfunction

## f with its last point and its best one kept; a point where it fails is one without a value; all
## are, once Ctrl-C or O.ends was there, or at ("interrupted"): at ("stopped") tells which, at
## ("best") what f gave at best
function at = memory_of (f, o)
  recalled (f, o);
  at = @recalled;
endfunction

function [e, count, text] = recalled (z, may_fail)
  persistent M;
  if (is_function_handle (z))
    M = struct ("f", z, "z", NaN, "e", [], "count", 0, "text", "", "ends", may_fail.ends, ...
                "guard", may_fail.guard, "stopped", "", "best", [], "at", z, "miss", Inf);
    return;
  elseif (strcmp (z, "interrupted"))
    M.stopped = z;
    return;
  elseif (ischar (z))
    [e, count] = deal (M.(z), M.at);
    return;
  endif
  if (! isequal (M.z, z(:)))
    M = moved (M, z(:), may_fail);
  endif
  [e, count, text] = deal (M.e, M.count, M.text);
endfunction

function M = moved (M, z, may_fail)
  M.z = NaN;
  M.e = [];
  if (isempty (M.stopped) && may_fail && time () > M.ends)
    M.stopped = "timeout";
  endif
  if (! isempty (M.stopped))
    return;
  endif
  M.count++;
  try
    [cut, M.e] = M.guard (@() M.f(z));
    M.stopped = {"", "interrupted", "timeout"}{1 + cut};
  catch err
    if (! may_fail)
      rethrow (err);
    endif
    M.text = err.message;
  end_try_catch
  M.z = z;
  if (! isempty (M.e))
    miss = max (1e-6, violation (M.e, sizes (M.e)));
    if (isempty (M.best) || miss < M.miss || (miss == M.miss && M.e.J < M.best.J))
      [M.best, M.at, M.miss] = deal (M.e, z, miss);
    endif
  endif
endfunction

function r = by_ipopt (who, model, q, o, memory, e, size_J, size_g)
  n = numel (q.z0);
  m = numel (e.g);
  [j, i] = meshgrid (1:n, 1:m);
  p = struct ("x0", q.z0, "low", finite (q.low), "high", finite (q.high), ...
              "glow", finite (e.low ./ size_g), "ghigh", finite (e.high ./ size_g), ...
              "jac", [i(:), j(:)], "hess", [], "f", ...
              @(what, z, factor, lambda) asked (memory, size_J, size_g, what, z, factor));
  if (q.newton)
    [row, col] = find (tril (ones (n)));
    p.hess = [row, col];
  endif
  o.options = {};
  if (q.newton)
    ## the barrier of the bounds stays below what flat sums of squares tell
    o.options = {"mu_init", 1e-8, "bound_push", 1e-8, "bound_frac", 1e-8};
  endif
  r = gs.run.run_ipopt (who, model, p, o);
  r.z = r.x;
  if (r.interrupted)
    memory ("interrupted");
  endif
endfunction

function v = asked (memory, size_J, size_g, what, z, factor)
  at = memory (z, true);
  if (isempty (at))
    error ("no value here");
  endif
  switch (what)
    case "f"
      v = at.J / size_J;
    case "grad"
      v = at.gJ / size_J;
    case "g"
      v = at.g ./ size_g;
    case "jac"
      v = (at.A ./ size_g)(:);
    case "hess"
      v = factor * at.H(tril (true (numel (z)))) / size_J;
  endswitch
endfunction

function x = finite (x)
  x = max (min (x, 2e19), -2e19);
endfunction

function r = by_nlopt (who, q, o, memory, e, size_J, size_g)
  if (! exist ("nlopt_optimize", "file"))
    error ("%s: NLopt is not installed (Debian: octave-nlopt)", who);
  endif
  word = struct ("slsqp", "NLOPT_LD_SLSQP", "mma", "NLOPT_LD_MMA", "cobyla", "NLOPT_LN_COBYLA");
  t = struct ("algorithm", feval (word.(o.solver)), "lower_bounds", q.low', ...
              "upper_bounds", q.high', "ftol_rel", 1e-15, "xtol_rel", o.tolerance, ...
              "maxeval", o.evaluations, "maxtime", o.seconds, ...
              "min_objective", @(z) goal (memory, z, size_J, size_g));
  upper = find (isfinite (e.high) & e.high > e.low);
  lower = find (isfinite (e.low) & e.high > e.low);
  equal = find (e.low == e.high);
  if (! isempty (equal) && strcmp (o.solver, "mma"))
    error (["%s: option solver: mma takes no equations (relation \"=\"); expected slsqp, " ...
            "cobyla or ipopt"], who);
  endif
  one = @(k, side) @(z) constraint (memory, z, k, side, size_g(k));
  t.fc = [arrayfun(@(k) one (k, 1), upper', "UniformOutput", false), ...
          arrayfun(@(k) one (k, -1), lower', "UniformOutput", false)];
  t.h = arrayfun (@(k) one (k, 1), equal', "UniformOutput", false);
  t.fc_tol = repmat (1e-10, 1, numel (t.fc));
  t.h_tol = repmat (1e-10, 1, numel (t.h));
  for empty = {"fc", "h"}
    if (isempty (t.(empty{1})))
      t = rmfield (t, {empty{1}, [empty{1} "_tol"]});
    endif
  endfor
  goal ();
  try
    [cut, z, ~, code] = o.watch (@() nlopt_optimize (t, q.z0'));
    if (cut)
      memory ("interrupted");
      [z, code] = deal (q.z0', -5);   # the best so far takes its place
    endif
  catch err
    if (! strcmp (err.identifier, "gsmbp:stopped"))
      rethrow (err);
    endif
    [z, code] = deal (q.z0', -5);
  end_try_catch
  r = struct ("z", z', "iterations", NaN, "limit", any (code == [5, 6]), "infeasible", false, ...
              "solved", any (code == [1, 3, 4]), "ended", sentence (code, o));
endfunction

function text = sentence (code, o)
  table = {1, "solved"; 3, "the goal changes no more"; 4, "the variables change no more"
           5, sprintf("stopped at the limit of %d evaluations", o.evaluations)
           6, sprintf("stopped at the limit of %g s", o.seconds)
           -5, "no progress in 30 evaluations"
           -4, "rounding hides further progress"; -1, "the solver failed"};
  k = find ([table{:,1}] == code);
  text = sprintf ("NLopt ended with %d", code);
  if (! isempty (k))
    text = table{k,2};
  endif
endfunction

## no number ends NLopt: where 30 evaluations brought neither a better goal nor one nearer to what
## is demanded (SLSQP goes on for ever where the demands contradict each other)
function varargout = goal (memory, z, size_J, size_g)
  persistent least near idle;
  if (nargin == 0)
    [least, near, idle] = deal (Inf, Inf, 0);
    return;
  endif
  e = memory (z', true);
  if (isempty (e))
    stop (memory);
    varargout = {Inf, zeros(size (z))};
    return;
  endif
  off = violation (e, size_g);
  idle++;
  if (off < near - 1e-6 * abs (near) || (off <= 1e-8 && e.J < least) || ! isfinite (near))
    idle = 0;
  endif
  near = min (near, off);
  if (off <= 1e-8)
    least = min (least, e.J);
  endif
  varargout = {e.J / size_J, e.gJ' / size_J};
  if (idle > 30)
    varargout{1} = NaN;
  endif
endfunction

function stop (memory)
  if (! isempty (memory ("stopped")))
    error ("gsmbp:stopped", "stopped");
  endif
endfunction

function varargout = constraint (memory, z, k, side, size_)
  e = memory (z', true);
  if (isempty (e))
    stop (memory);
    varargout = {Inf, zeros(size (z))};
  elseif (side > 0)
    varargout = {(e.g(k) - e.high(k)) / size_, e.A(k,:) / size_};
  else
    varargout = {(e.low(k) - e.g(k)) / size_, -e.A(k,:) / size_};
  endif
endfunction
