## p = gs.run.plan_many (who, m, x0, times, pairs)
## One of many runs of the model M (gs.run.plan_run), refused where it cannot be: with METHOD and
## ATOL; PAIRS: names and values of options of gsmbp_simulate.  Each run starts from X0 as it is
## given, moved onto its own constraints.

function p = plan_many (who, m, x0, times, pairs)
  k = find (ismember (pairs(1:2:end), {"sensitivity", "dx0", "fixed", "audit", "samples"}), 1);
  if (! isempty (k))
    error ("%s: option %s is for one run alone, by gsmbp_simulate", who, pairs{2*k-1});
  endif
  o = gs.given.call_options (who, gs.run.option_table (), pairs);
  if (is_function_handle (o.input))
    error (["%s: option input: expected constants, a piecewise polynomial or \"user\", found a " ...
            "function of Octave, which cannot run on several cores"], who);
  endif
  o.samples = false;
  p = gs.run.plan_run (who, m, x0, times, o);
  p.method = o.method;
  first = gs.run.prepare_run (who, p);
  p.atol = first.atol;
endfunction
