## before_record (scenes, file)
## Write the runs of SCENES (before_scenes) into FILE, a line each (before_line), or one for a
## scene that was left out.
##
## The error of a run is the smaller of two, once for the last state and once for the times of
## events: its distance from the same problem in quad precision; its distance from the run with a
## tenth of the tolerance, or with fixed steps from a state moved by 1e-14: what its tolerance, or
## rounding, explains.

function before_record (scenes, file)
  id = fopen (file, "w");
  if (id < 0)
    error ("before_record: cannot write %s", file);
  end
  failed = {};
  for scene = scenes
    printf ("%s\n", scene.name);
    fflush (stdout);
    try
      fprintf (id, "%s\n", recorded (scene){:});
    catch e
      failed{end + 1} = sprintf ("%s: %s", scene.name, e.message);
    end
  end
  if (fclose (id) != 0)
    error ("before_record: cannot write %s", file);
  elseif (! isempty (failed))
    error ("before_record: %s", strjoin (failed, "\n"));
  end
end

function lines = recorded (scene)
  [m, given] = before_model (scene);
  if (! any (strcmp (m.subroutines, "rhs")))
    lines = {[scene.name " - left out: has no RHS (" strjoin(m.subroutines(:)', " ") ")"]};
    return;
  end
  quad = before_model (scene, "precision", "quad");
  lines = {};
  known = struct ("x0", {}, "problem", {}, "run", {});
  for of = before_plan (m, given)
    run = before_run (m, of);
    if (isempty (run.text))
      [right, known] = exact (m, quad, of, known);
      run.error = min (before_distance (m, run, right), before_distance (m, run, again (m, of)));
    end
    lines{end + 1} = before_line (scene.name, run);
  end
end

## The same problem in quad precision: with the same steps where these are fixed, so that rounding
## alone makes a difference, else solved to 1e-17 if dp853 of the model M solves it in 500 steps
## (others take minutes). KNOWN: those that were solved before.
function [run, known] = exact (m, quad, of, known)
  if (strcmp (of.method, "rk4"))
    run = before_run (quad, of);
    return;
  end
  for one = known
    if (isequal ({one.x0, one.problem}, {of.x0, of.problem}))
      run = one.run;
      return;
    end
  end
  [of.method, of.solver] = deal ("dp853", {});
  run = before_run (m, of);
  if (isequal (run.info, 0) && run.counts(2) <= 500)
    run = before_run (quad, of, {"rtol", 1e-17, "maxsteps", 1e4});
  else
    run.info = [];   # none
  end
  known(end + 1) = struct ("x0", of.x0, "problem", {{of.problem}}, "run", run);
end

## the same problem by a tenth of the tolerance; by the same fixed steps from a state moved by some
## hundred units of rounding, which tells what rounding makes of them
function run = again (m, of)
  if (any (strcmp (of.method, {"rk4", "gauss"})))
    of.x0 += 1e-14 * cos (3 * (1:m.sizes.nx)') .* m.nominal;
    run = before_run (m, of);
  else
    run = before_run (m, of, {"rtol", 1e-11});
  end
end
