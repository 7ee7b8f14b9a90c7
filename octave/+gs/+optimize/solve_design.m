## [best, ends] = gs.optimize.solve_design (who, P, o)
## The best end of a design by its continuous variables, from one start or several.  BEST: what
## gs.optimize.solve_nlp gives, with P, q (the problem), p (the values), solved, optimality, active.

function [best, ends] = solve_design (who, P, o)
  ends = struct ("values", {}, "J", {}, "solved", {}, "violation", {}, "ended", {});
  best = [];
  Z = places (P, o);
  for k = 1:columns (Z)
    if (k > 1 && time () >= o.ends)
      best = cut_short (best, "timeout");
      break;
    endif
    try
      [cut, P_, q] = o.guard (@() set_up (P, Z(:,k)));
      if (cut)
        error ("gsmbp:stopped", "%s: %s before the first values were there", who, ...
               gs.run.stopped_text ({"interrupted", "timeout"}{cut}));
      endif
      P = P_;
      used = solver (P, q, o);
      [cut, r] = o.watch (@() one (who, P, q, setfield (o, "solver", used)));
      if (cut)
        error ("gsmbp:stopped", "%s: %s between evaluations", who, ...
               gs.run.stopped_text ("interrupted"));
      endif
    catch err
      if (k > 1 && ! isempty (gs.optimize.cut_word (err, o)))
        best = cut_short (best, gs.optimize.cut_word (err, o));
        break;
      elseif (k == 1)
        rethrow (err);
      endif
      values = gs.optimize.values_struct (P, Z(:,k) .* reshape ([P.free.scale], [], 1));
      ends(end+1) = struct ("values", values, "J", NaN, "solved", false, "violation", NaN, ...
                            "ended", ["no start: " err.message]);
      continue;
    end_try_catch
    r.solver = used;
    ends(end+1) = struct ("values", gs.optimize.values_struct (P, r.p), "J", r.e.J, "solved", ...
                          r.solved, "violation", r.violation, "ended", r.ended);
    if (isempty (best) || (r.violation <= 1e-6) > (best.violation <= 1e-6) ...
        || ((r.violation <= 1e-6) == (best.violation <= 1e-6) && r.e.J < best.e.J))
      best = r;
    endif
    if (! isempty (r.stopped))
      best = cut_short (best, r.stopped);
      break;
    endif
  endfor
endfunction

function best = cut_short (best, stopped)
  best.stopped = stopped;
  best.ended = gs.run.stopped_text (stopped);
  best.limit = true;
  best.solved = false;
endfunction

## columns: the start, then others, given or by chance
function Z = places (P, o)
  f = P.free;
  scale = reshape ([f.scale], [], 1);
  Z = reshape ([f.start], [], 1) ./ scale;
  if (! isscalar (o.starts) && ! isempty (f))
    Z = [Z, P.places' ./ scale];
  endif
  if (! isscalar (o.starts) || o.starts < 2 || isempty (f))
    return;
  endif
  before = rand ("state");
  guard = onCleanup (@() rand ("state", before));
  rand ("state", o.seed);
  low = [f.low]';
  high = [f.high]';
  Z = [Z, (low + (high - low) .* rand (numel (f), o.starts - 1)) ./ scale];
endfunction

function word = solver (P, q, o)
  word = o.solver;
  if (! strcmp (word, "auto"))
    return;
  endif
  word = "slsqp";
  if (q.newton || ! exist ("nlopt_optimize", "file"))
    word = "ipopt";
  endif
endfunction

## the problem of the solver, with a number above each peak that is a goal
function [P, q] = set_up (P, start)
  n = numel (P.free);
  scale = reshape ([P.free.scale], [], 1);
  peaks = sum ([P.goal.above]);
  P.sizes = ones (1, peaks);
  z = [start; zeros(peaks, 1)];
  e = gs.optimize.assess_values (P, z);
  P.idle = nothing_depends (P, e);
  if (peaks > 0)
    ## above all values from the beginning
    for s = 1:peaks
      k = e.A(:,n+s) != 0 & e.row == 0;
      ahead = -e.g(k) ./ e.A(k,n+s);
      top = merge (e.A(find (k, 1),n+s) < 0, max (ahead), min (ahead));
      P.sizes(s) = max (abs (top), 1e-12);
      z(n+s) = top / P.sizes(s);
    endfor
  endif
  q.z0 = z;
  q.low = [reshape([P.free.low], [], 1) ./ scale; -Inf(peaks, 1)];
  q.high = [reshape([P.free.high], [], 1) ./ scale; Inf(peaks, 1)];
  q.f = @(z) gs.optimize.assess_values (P, z);
  q.newton = ! isempty (P.goal) && all (strcmp ({P.goal.word}, "square")) ...
             && all ([P.goal.factor] > 0) && isempty (P.demands);
endfunction

## the parameters on which nothing depends at the start; of a variable of the user's an error
function idle = nothing_depends (P, e)
  idle = {};
  for k = 1:numel (P.free)
    if (! (e.gJ(k) == 0 && all (e.A(:,k) == 0)))
      continue;
    endif
    idle{end+1} = P.free(k).name;
    if (strcmp (P.free(k).kind, "own"))
      error ("%s: nothing depends on %s at the start (no parameter of %s has that name)", P.who, ...
             P.free(k).name, P.base.name);
    endif
  endfor
endfunction

function r = one (who, P, q, o)
  if (isempty (q.z0))
    ended = merge (isempty (fieldnames (P.given)), "nothing is free", "all is chosen from lists");
    e = q.f(q.z0);
    r = struct ("z", q.z0, "e", e, "iterations", 0, "evaluations", 1, "ended", ...
                ended, ...
                "limit", false, "trouble", "", "stopped", "", "size_J", 1, ...
                "size_g", max ([abs(e.g), ones(numel (e.g), 1)], [], 2));
    r.violation = max ([0; (e.low - e.g) ./ r.size_g; (e.g - e.high) ./ r.size_g]);
    r.optimality = 0;
  else
    r = gs.optimize.solve_nlp (who, P.base, q, o);
  endif
  [r.active, r.optimality] = gs.optimize.active_prices (P, q, r);
  r.p = r.e.p;
  r.P = P;
  r.q = q;
  feasible = r.violation <= 1e-6;
  r.solved = feasible && ! r.limit && (r.optimality <= 1e-4 || isempty (P.goal));
endfunction
