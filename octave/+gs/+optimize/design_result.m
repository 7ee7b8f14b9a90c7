## [r, info] = gs.optimize.design_result (P, s)
## What gsmbp_optimize gives: of the problem P and what the engine has found (S, glue/design.h).

function [r, info] = design_result (P, s)
  r.values = gs.optimize.values_struct (P, s.values);
  r.J = s.J;
  r.model = gs.optimize.design_model (P, s.values);
  r.results = results (P, s);
  solvers = gs.text.table_rows ("GS_DESIGN_SOLVERS");
  s.solver = solvers{s.solver};
  for k = 1:numel (s.starts)
    s.starts(k).values = gs.optimize.values_struct (P, s.starts(k).values);
  endfor
  for name = {"active", "solved", "ended", "limit", "violation", "optimality", "iterations", ...
              "evaluations", "solver", "starts", "stopped", "derivatives"}
    r.(name{1}) = s.(name{1});
  endfor
  r.conflict = {P.demands(s.conflict).text};
  [r.choices, r.report] = deal (s.choices, s.report);
  info = s.info;
  idle = {P.free(logical (s.idle)).name};
  if (! isempty (idle))
    warning ("gsmbp:idle", "%s: %s: nothing depends on %s, at the start and at the end", P.who, ...
             r.model.name, strjoin (idle, ", "));
  endif
endfunction

## of the load cases at the values; where demands contradict each other, those that can be there
function list = results (P, s)
  list = struct ();
  for c = P.cases
    try
      list.(c.name) = gs.optimize.run_case (P, c, s.values);
    catch err
      if (s.info != 2)   # no goal or demand has read it, or it would have failed before
        pairs = [{P.free.name}; num2cell(s.values(:)')];
        error (err.identifier, "%s; at the values found: %s", err.message, ...
               strjoin (cellfun (@(name, x) sprintf ("%s = %.6g", name, x), pairs(1,:), ...
                                 pairs(2,:), "UniformOutput", false), ", "));
      endif
    end_try_catch
  endfor
endfunction
