## p = gs.run.plan_run (who, m, x0, times, o)
## A run of the model M from X0 at TIMES(1) by the options O of gsmbp_simulate, checked and laid
## out: a struct with M (its way of the loops set), O (completed), X0 and ATOL (with the states of
## an audit and of derivatives), TIMES, METHOD, ROPT, START (see gs.start.consistent_start),
## CARRIED, and ARGUMENTS of the module's "sim".

function p = plan_run (who, m, x0, times, o)
  d = m.sizes;
  p.times = times = gs.given.given_times (who, times);
  if (numel (times) < 2)
    error ("%s: %s", who, gs.text.refusal_text ("one_time", sprintf ("%.15g alone", times)));
  endif
  [m, way, index2] = gs.run.loop_way (who, o, m);
  [iopt, p.ropt, atol, p.method, order] = gs.run.integration_options (who, o, d, m, way);
  t0 = times(1);
  check_number (who, p.method, p.ropt, times(end) - t0);
  [x0, p.start] = gs.start.consistent_start (who, m, t0, x0, o.start, o.modes);
  if (isempty (o.motion))
    o.of_time = of_time (o.input);
    o.input = gs.run.whole_input (who, m, o.input, t0, x0);
  endif
  [plan, breaks, callback] = gs.run.input_plan (who, o, m);
  if (is_function_handle (callback) && ! isempty (m.controllers))
    plan.constants = callback (t0, x0)(:)';   # what is held before the first samples
  endif
  plan = gs.run.sample_plan (who, m, o, times, plan);
  plan = gs.events.plan_events (who, m, o, plan);
  p.carried = gs.linear.carried_columns (who, m, o, t0, x0, atol);
  o.rtol = p.ropt(2);
  [p.x0, p.atol] = audit_states (who, m, o, [x0(:); p.carried.x0], [atol(:); p.carried.atol]);
  breaks = unique ([breaks, double(o.breaks(:)')]);
  ends = breaks(breaks == t0 | breaks == times(end));   # of them only a function of Octave is told
  breaks = breaks(breaks > t0 & breaks < times(end));
  library = "";
  row = gs.run.method_row (p.method);
  if (! strcmp (row.by, "core"))
    library = strrep (p.method, "auto", "radau");
    row = gs.run.method_row (library);
    if (strcmp (row.by, "library"))
      library = gs.model.host_library (who, m, library);
    endif
  endif
  guess = zeros (d.nu, 1);
  if (d.nq == d.nu)
    guess = p.x0(1:d.nq);
  endif
  counts = [numel(times), numel(breaks)];
  if (is_function_handle (callback))
    breaks = [breaks, ends];
  endif
  p.arguments = {m.cst, t0, p.x0, p.carried.columns, times, breaks, counts, iopt, p.ropt, ...
                 p.atol, plan, guess, callback, library, [order, index2, m.internal'], o.timeout};
  [p.m, p.o] = deal (m, o);
endfunction

## the number of steps: of a fixed length what GSSIM (gsarg.f) counts to, else what time resolves
function check_number (who, method, ropt, span)
  row = gs.run.method_row (method);
  fixed = row.fixed;
  most = gs.text.run_limit ({"controlled_steps", "fixed_steps"}{1 + fixed});
  steps = [ropt(1) * fixed, ropt(3)];
  steps(steps == 0) = Inf;
  [step, which] = min (steps);
  if (span / step > most)
    error ("%s: option %s: %s", who, {"step", "maxstep"}{which}, ...
           gs.text.refusal_text ("too_many_steps", span, step, span / step, method, most));
  endif
endfunction

## the two states of an audit and their tolerances
function [x0, atol] = audit_states (who, m, o, x0, atol)
  if (isempty (o.audit))
    return;
  endif
  if (! any (strcmp (m.subroutines, "rha")))
    error (["%s: option audit needs the subroutine RHA (request audit), which %s was " ...
            "emitted without"], who, m.name);
  elseif (! isempty (o.gain))
    error ("%s: no audit with state feedback from outside", who);
  endif
  x0 = [x0(:); 0; 0];
  atol = [atol(:); o.rtol * o.audit * [1; 1]];
endfunction

## is an input a function of time, by its text?
function is = of_time (f)
  is = false;
  if (is_function_handle (f))
    part = regexp (func2str (f), '^@\(\s*\w+\s*,\s*(\w+)\s*\)(.*)$', "tokens", "once");
    is = ! isempty (part) && ! any (strcmp (regexp (part{2}, '\w+', "match"), part{1}));
  endif
endfunction
