## run = before_run (m, of, options)
## Run the model M half a second as OF (a row of before_plan) says, with OPTIONS in the place of its
## own: a struct (before_empty).

function run = before_run (m, of, options = {})
  run = before_empty ();
  run.name = of.name;
  start = {"check", "project"}{1 + any(strcmp (m.subroutines, "prj"))};
  options = [{"method", of.method, "start", start, "maxsteps", 5000, "timeout", 120}, ...
             of.problem, of.solver, options];
  [~, k] = unique (options(1:2:end), "last");   # the later of two is taken
  options = [options(2*k-1); options(2*k)];
  [r, info, run.id, run.text, run.warned] = called (m, of.x0, options);
  if (! isempty (info))
    run.info = info;
    run = of_result (run, r, r.stats);
  end
  if (! isempty (info) && info != 0)   # the message is that of a call without INFO
    [~, ~, run.id, run.text] = called (m, of.x0, options, true);
  end
end

function run = of_result (run, r, s)
  run.reached = s.reached;
  run.counts = [s.calls, s.accepted, s.rejected, s.projections];
  if (! isempty (r.x))
    run.x = [r.x(end,:), extra(r)];
  end
  if (isfield (r, "events"))
    run.happened = s.events;
    k = 1:min (20, numel (r.events.t));
    run.times = r.events.t(k)(:)';
    run.events = strtrim (sprintf ("%s ", arrayfun (@(k) sprintf ("%s %g", r.events.name{k}, ...
      r.events.mode(k)), k, "UniformOutput", false){:}));
  end
end

## one call of gsmbp_simulate; PLAIN: without INFO. An error gives ID and TEXT, no INFO
function [r, info, id, text, warned] = called (m, x0, options, plain = false)
  [r, info, id, text] = deal ([], [], "", "");
  times = [0 0.25 0.5];
  code = "[r, info] = gsmbp_simulate (m, x0, times, options{:});";
  if (plain)
    code = "r = gsmbp_simulate (m, x0, times, options{:}); text = r.stats.stopped;";
  end
  lastwarn ("", "");
  try
    evalc (code);   # which keeps warnings from the screen
  catch e
    id = [e.identifier "-"(isempty (e.identifier))];
    text = strrep (e.message, "\n", " ");
  end
  [~, warned] = lastwarn ();
end

## what else the run says of its end
function numbers = extra (r)
  numbers = [];
  if (isfield (r.stats, "memory"))
    numbers = r.stats.memory(:)';
  end
  if (isfield (r, "audit"))
    numbers(end + 1) = r.audit.passed(end);
  elseif (isfield (r, "dx"))
    numbers = [numbers, struct2cell(r.dx){1}(end,:)];
  end
end
