## line = before_line (scene, run)
## Write a run (before_run) of SCENE as one line, which before_read reads; what is empty is left
## out:
##
##     SCENE METHOD VARIANT | info INFO REACHED | counts CALLS STEPS FAILED PROJECTIONS | x NUMBERS
##     | error OF_X OF_TIMES | events NUMBER TIMES | modes EVENTS | warned ID | stopped ID TEXT

function line = before_line (scene, run)
  parts = {[scene " " run.name]};
  if (! isempty (run.info))
    parts{end + 1} = ["info" sprintf(" %.15g", run.info, run.reached)];
    parts{end + 1} = ["counts" sprintf(" %d", run.counts)];
    parts{end + 1} = ["x" sprintf(" %.15g", run.x)];
    parts{end + 1} = sprintf ("error %.1e %.1e", run.error);
  end
  if (run.happened > 0)
    parts{end + 1} = ["events" sprintf(" %.15g", run.happened, run.times)];
    parts{end + 1} = ["modes " run.events];
  end
  if (! isempty (run.warned))
    parts{end + 1} = ["warned " run.warned];
  end
  if (! isempty (run.text))
    parts{end + 1} = ["stopped " run.id " " run.text];
  end
  line = strjoin (parts, " | ");
end
