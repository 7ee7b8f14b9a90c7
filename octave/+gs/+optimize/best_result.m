## [r, info] = gs.optimize.best_result (who, best, o, P, tally)
## What gsmbp_optimize gives: from the best end; TALLY: what gs.optimize.try_choices tells of
## the choices; INFO as the help of gsmbp_optimize says.

function [r, info] = best_result (who, best, o, P, tally)
  Q = best.P;
  r.values = gs.optimize.values_struct (Q, best.p);
  r.J = best.e.J;
  r.model = Q.model(best.p);
  r.results = best.e.results;
  r.active = told (best.active);
  for name = {"solved", "ended", "limit", "violation", "optimality", "iterations", ...
              "evaluations", "solver", "starts", "stopped"}
    r.(name{1}) = best.(name{1});
  endfor
  r.derivatives = derivatives (Q, best);
  r.conflict = {};
  info = merge (r.solved, 0, merge (r.limit, 1, 3));
  if (best.violation > 1e-6 && ! r.limit && ! isempty (Q.demands))
    [r, info] = contradiction (who, r, Q, best, o);
  elseif (info == 3)
    r.ended = sprintf ("%s, %s %.2g (%s)", r.ended, ...
                       "what is left of the conditions of an optimum:", r.optimality, r.solver);
    if (! isempty (best.trouble))
      r.ended = sprintf ("%s; at some values: %s", r.ended, best.trouble);
    endif
  endif
  r.choices = tally;
  moved = any ([best.e.gJ(1:numel (Q.free))'; best.e.A(:,1:numel (Q.free))] != 0, 1);
  idle = {Q.free(! moved & ismember ({Q.free.name}, Q.idle)).name};
  if (! isempty (idle))
    warning ("gsmbp:idle", "%s: %s: nothing depends on %s, at the start and at the end", who, ...
             r.model.name, strjoin (idle, ", "));
  endif
  r.report = report (P, r, tally);
endfunction

function [r, info] = contradiction (who, r, Q, best, o)
  [least, near, bounds] = gs.optimize.find_conflict (who, Q, best.q, o);
  info = 2;
  r.active = r.active([]);
  r.conflict = {Q.demands(least).text};
  r.values = gs.optimize.values_struct (Q, near .* [Q.free.scale]');
  words = "these demands contradict each other";
  if (isscalar (least))
    words = "this demand cannot be met";
  endif
  r.ended = sprintf ("%s: %s", words, strjoin (r.conflict, "; "));
  if (! isempty (bounds))
    r.ended = sprintf ("%s (within %s)", r.ended, strjoin (bounds, ", "));
  endif
  r.ended = sprintf ("%s; they are missed by least at %s", r.ended, listed (r.values));
  if (! isempty (fieldnames (Q.given)))
    r.ended = sprintf ("%s, of all choices with %s", r.ended, listed (Q.given));
  endif
endfunction

function text = listed (values)
  text = strjoin (cellfun (@(name) sprintf ("%s = %.6g", name, values.(name)), ...
                           fieldnames (values)', "UniformOutput", false), ", ");
endfunction

## those that hold the goal back, each text once, with the sum of its multipliers
function list = told (active)
  list = struct ("text", {}, "kind", {}, "value", {}, "bound", {}, "multiplier", {});
  for a = active(! strcmp ({active.kind}, "peak"))
    k = find (strcmp ({list.text}, a.text), 1);
    if (isempty (k))
      list(end+1) = rmfield (a, {"k", "sign"});
    else
      list(k).multiplier += a.multiplier;
    endif
  endfor
endfunction

function text = derivatives (Q, best)
  rough = {Q.free(best.e.rough).name};
  text = "exact";
  if (! isempty (rough))
    text = sprintf ("differences of order 4 by %s", strjoin (rough, ", "));
    if (numel (rough) < numel (Q.free))
      text = [text ", exact by the others"];
    endif
    if (! isempty (Q.why))
      text = sprintf ("%s: %s", text, strjoin (Q.why, "; "));
    endif
  endif
  if (best.e.functions)
    text = [text "; of functions: differences of order 4"];
  endif
endfunction

function text = report (P, r, tally)
  line = @(varargin) [sprintf(varargin{:}) "\n"];
  text = line ("%s: goal %.9g, %s", P.base.name, r.J, r.ended);
  for f = P.free
    value = r.values.(strrep (f.name, ".", "_"));
    range = sprintf ("%g to %g", f.low, f.high);
    if (! isempty (f.list))
      range = ["one of " strjoin(cellfun (@(v) sprintf ("%g", v), num2cell (f.list), ...
                                          "UniformOutput", false), ", ")];
    endif
    text = [text, line("  %-20s %16.9g   (%s)", f.name, value, range)];
  endfor
  for a = r.active
    text = [text, line("  active: %s, multiplier %.6g", a.text, a.multiplier)];
  endfor
  text = [text, line("  %d evaluations, %s; derivatives: %s", r.evaluations, r.solver, ...
                     r.derivatives)];
  if (strcmp (tally.how, "branch"))
    text = [text, line("  choices: branch and bound, %d problems solved for %d combinations", ...
                       tally.solved, tally.combinations)];
  elseif (numel (r.starts) > 1)
    text = [text, line("  best of %d ends (%d starts, %d combinations)", numel (r.starts), ...
                       numel (r.starts) / tally.combinations, tally.combinations)];
  endif
endfunction
