## plan = gs.run.sample_plan (who, m, o, times, plan)
## The plan of a run with its samples, where the scene M has sampled devices.  O: the options of
## gsmbp_simulate (memory, samples); periods, delays and the first samples are filled in by
## the module.

function plan = sample_plan (who, m, o, times, plan)
  d = m.sizes;
  nc = numel (m.controllers);
  if (nc == 0)
    if (! isempty (o.memory))
      error ("%s: option memory: %s has no sampled devices", who, m.name);
    endif
    return;
  endif
  if (! any (strcmp (m.subroutines, "ctl")))
    error (["%s: %s has sampled devices, but was emitted without the subroutine CTL " ...
            "(request control)"], who, m.name);
  endif
  [period, delay] = m.module ("ctp", m.cst);
  if (! all (period > 0) || ! all (delay >= 0))
    k = find (! (period > 0) | ! (delay >= 0), 1);
    error ("%s: %s: period and delay must be > 0 and >= 0; found %g s and %g s", who, ...
           m.controllers(k).name, period(k), delay(k));
  endif
  memory = o.memory;
  if (isempty (memory))
    memory = vertcat (m.controllers.starts);
  endif
  if (! (isnumeric (memory) && numel (memory) == d.nxk && all (isfinite (memory(:)))))
    error ("%s: option memory: %s", who, ...
           gs.text.refusal_text ("memory", d.nxk, gs.text.shown_value (memory)));
  endif
  check_memory (who, m, double (memory(:)'));
  plan.memory = double (memory(:)');
  if (any (max (abs (times([1, end]))) ./ period > gs.text.run_limit ("fixed_steps")))
    error ("%s: more than 2e9 samples", who);
  endif
  [plan.on_the_way, instants] = m.module ("pending", period, delay, times(end) - times(1));
  if (o.samples)
    plan.instants = instants;
  endif
  plan.held_counts = cellfun (@numel, {m.controllers.outputs});
  plan.again = double ([m.controllers.again]);
  plan.held_inputs = vertcat (m.controllers.outputs)';
endfunction

## what the entries say of a memory that can be
function check_memory (who, m, memory)
  for one = m.controllers
    own = num2cell (memory(1:numel (one.memory)));
    memory(1:numel (one.memory)) = [];
    for rule = gs.model.json_rows (one, "possible")
      letters = sprintf (", p%d", 1:numel (own))(3:end);
      if (str2func (sprintf ("@(%s) %s", letters, rule{1}.value)) (own{:}) < 0)
        pairs = cellfun (@(name, x) sprintf ("%s = %.6g", name, x), one.memory(:)', own, ...
                         "UniformOutput", false);
        error ("%s: option memory: %s: expected %s; found %s", who, one.name, rule{1}.text, ...
               strjoin (pairs, ", "));
      endif
    endfor
  endfor
endfunction
