## gs.run.refuse_run (who, m, found)
## An error of WHO where the engine has refused a run of the model M, a warning where it has raised
## a tolerance.  FOUND: as the module gives it (glue/run.h).

function refuse_run (who, m, found)
  if (! isempty (found.warning))
    warning ("gsmbp:tolerance", "%s: %s: %s", who, m.name, found.warning);
  endif
  option = {"", ["option " found.option ": "]}{1 + ! isempty(found.option)};
  switch (found.refused)
    case ""
      return;
    case "start"
      gs.start.refuse_start (who, m, "x0", found.start, found.text);
    case "routine"
      error ("gsmbp:absent", "%s.%s: %s", m.name, found.option, found.text);
    case "mode"
      error ("%s: %s: %s%s", who, m.name, option, found.text);
    case "need"
      error ("%s: %s", who, found.text);
    otherwise
      error ("%s: %s%s", who, option, found.text);
  endswitch
endfunction
