## before_check (scenes, file[, rounding])
## Compare the runs of SCENES (before_scenes) that FILE has (before_record) with those of today: a
## line ok for each scene, not ok for each run that differs. Of the runs that the file ROUNDING
## names, which differ by processor, INFO, error and warnings alone.

function before_check (scenes, file, rounding)
  rough = {};
  if (nargin > 2)
    rough = regexp (fileread (rounding), '^(?!#)([^:\n]+):', "tokens", "lineanchors");
    rough = [rough{:}];
  end
  for scene = scenes
    then = before_read (file, scene.name);
    if (isempty (then))
      continue;
    end
    [m, given] = before_model (scene);
    if (strcmp (then(1).name, "-"))
      gsmbp_check (["before: " scene.name ": left out, has no RHS"], ...
                   ! any (strcmp (m.subroutines, "rhs")));
      continue;
    end
    plan = before_plan (m, given);
    same = isequal ({then.name}, {plan.name});
    if (! same)
      gsmbp_check (["before: " scene.name ": the list of runs"], false);
      continue;
    end
    for k = 1:numel (plan)
      whole = ! any (strcmp ([scene.name " " plan(k).name], rough));
      differences = before_differ (m, then(k), before_run (m, plan(k)), whole);
      if (! isempty (differences))
        same = false;
        gsmbp_check (["before: " scene.name " " plan(k).name ": " strjoin(differences, "; ")], ...
                     false);
      end
    end
    if (same)
      gsmbp_check (sprintf ("before: %s: %d runs", scene.name, numel (plan)), true);
    end
  end
end
