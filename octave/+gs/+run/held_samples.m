## list = gs.run.held_samples (m, result, start)
## The controllers of M that calculate through loops and drives (gsmbp_model_control): a struct
## array of their NAME, how many SAMPLES of the run had no command, so that the inputs stayed as
## they were, and the time of the FIRST of them [s], NaN where none is or samples are not kept.
## START: the memory that the run began with, [] for that of the controllers.

function list = held_samples (m, result, start)
  list = struct ("name", {}, "samples", {}, "first", {});
  if (isempty (start))
    start = vertcat (m.controllers.starts);
  endif
  at = 0;
  for one = m.controllers
    at += numel (one.memory);
    if (isempty (one.memory) || ! strcmp (one.memory{end}, [one.name ".held_samples"]))
      continue;
    endif
    first = [result.samples.t(result.samples.xk(:,at) > start(at)); NaN](1);
    list(end+1) = struct ("name", one.name, "samples", result.memory(at) - start(at), ...
                          "first", first);
  endfor
endfunction
