## [o, rest] = gs.sweep.sweep_options (who, m, pairs)
## The options of gsmbp_sweep, and the names and values of those that are gsmbp_simulate's.

function [o, rest] = sweep_options (who, m, pairs)
  table = {"vary", struct(), "any"
           "plan", "sobol", {"sobol", "latin", "random", "grid", "corners", "indices"}
           "runs", 256, "whole"
           "seed", 1, "whole"
           "keep", {}, "names"
           "loop", [], "any"
           "demand", {}, "any"
           "threads", nproc(), "whole"
           "lanes", true, "flag"
           "file", "", "text"
           "program", "", "text"
           "timeout", 0, "nonnegative"
           "resume", false, "flag"
           "chunk", 16384, "whole"};
  [names, values] = gs.given.name_value_pairs (who, "option", pairs);
  known = gs.run.option_table ();
  known = setdiff (known(:,1), {"timeout"});
  k = find (! ismember (names, [table(:,1); known]), 1);
  if (! isempty (k))
    error ("%s: unknown option %s", who, gs.text.nearest_word (names{k}, sort ([table(:,1); ...
                                                                                known])'));
  endif
  mine = ismember (names, table(:,1));
  o = gs.given.call_options (who, table, [names(mine); values(mine)](:)');
  rest = [names(! mine); values(! mine)](:)';
  if (! any (strcmp (names, "vary")))
    error (["%s: option vary is missing: expected a struct with a range, a list or a " ...
            "distribution for each parameter that varies"], who);
  elseif (! (isstruct (o.vary) && isscalar (o.vary) && numfields (o.vary) > 0))
    error (["%s: option vary: expected a struct with a range, a list or a distribution for " ...
            "each parameter, found %s"], who, gs.text.shown_value (o.vary));
  elseif (o.resume && isempty (o.file))
    error ("%s: option resume goes on with what stands beside option file, which is missing", who);
  endif
  if (! (isempty (o.file) || isempty (o.program)))
    error (["%s: options file and program: expected one of them: a program writes its table " ...
            "itself, sweep.h5 in its folder"], who);
  endif
  for name = {"file", "program"}
    if (isempty (o.(name{1})) && any (strcmp (names, name{1})))
      error ("%s: option %s: expected a name, found an empty text", who, name{1});
    endif
  endfor
  if (any (strcmp (o.plan, {"grid", "corners"})) && any (strcmp (names, "runs")))
    error (["%s: option runs: expected none for the plan \"%s\", whose runs follow from option " ...
            "vary, found %g"], who, o.plan, o.runs);
  endif
  if (o.timeout > 0 && ! isempty (o.program))
    error ("%s: option timeout is for the runs of this session, not for option program", who);
  endif
  for name = {"runs", "threads", "chunk"}
    if (! (o.(name{1}) >= 1))
      error ("%s: option %s: expected a whole number above 0, found %g", who, name{1}, ...
             o.(name{1}));
    endif
  endfor
endfunction
