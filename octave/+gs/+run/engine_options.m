## run = gs.run.engine_options (who, m, o)
## The members of gs_run_options (share/engine/host/run/run.h) that say how the model M is
## integrated, of the options O of gsmbp_simulate; the engine looks at what they mean together.

function run = engine_options (who, m, o)
  row = gs.run.method_row (o.method);
  number = @(x) [x, NaN](1);
  is_given = @(x) ! (isnumeric (x) && isempty (x));
  if (is_given (o.step))
    gs.given.check_kind (who, "option step", o.step, {"nonnegative", "positive"}{1 + row.fixed});
  endif
  if (is_given (o.maxorder))
    gs.given.check_kind (who, "option maxorder", o.maxorder, "number");
  endif
  if (is_given (o.audit))
    gs.given.check_kind (who, "option audit", o.audit, "positive");
  endif
  if (row.fixed && ! isnan (o.rtol) && isempty (o.audit))
    warning ("gsmbp:option", ["%s: option rtol: method \"%s\" has steps of one length and does " ...
                              "not use it; the option \"step\" sets its error"], who, o.method);
  endif
  library = "";
  if (strcmp (row.by, "library") && strcmp (m.precision, "double"))
    library = gs.model.host_library (who, m, o.method);
  endif
  run = struct ("method", o.method, "loops", way_of_loops (who, m, o), "step", number (o.step), ...
                "rtol", o.rtol, "atol", tolerances (who, m, o.atol), "maxstep", o.maxstep, ...
                "maxsteps", o.maxsteps, "maxorder", number (o.maxorder), "drift", ...
                double ([o.drift, -1](1)), "project", double (strcmp (o.start, "project")), ...
                "samples", double (o.samples), "audit", [o.audit, 0](1), "library", library, ...
                "timeout", o.timeout);
endfunction

## one for each state, [] where none is given
function atol = tolerances (who, m, given)
  fits = isnumeric (given) && isreal (given) && any (numel (given) == [0, 1, m.sizes.nx]) ...
         && (isempty (given) || isvector (given));
  if (! (fits && all (given(:) >= 0) && all (isfinite (given(:)))))
    error ("%s: option atol: %s", who, ...
           gs.text.refusal_text ("atol", m.sizes.nx, gs.text.shown_value (given)));
  endif
  atol = double (given(:));
  if (isscalar (atol))
    atol = repmat (atol, m.sizes.nx, 1);
  endif
endfunction

## a word of GS_LOOP_METHODS, "": what the scene needs
function word = way_of_loops (who, m, o)
  word = o.loops;
  if (! isempty (o.projection))
    if (! isempty (word))
      error ("%s: give \"loops\" or \"projection\", not both", who);
    endif
    word = {"baumgarte", "projection"}{1 + logical(o.projection)};
    if (o.projection && ! any (strcmp (m.subroutines, "prj")))
      error ("%s: %s", who, gs.text.refusal_text ("routine", sprintf ("the way \"%s\"", word), ...
                                                  "PRJ", m.name));
    endif
    return;
  elseif (isempty (word))
    word = "";
    return;
  endif
  table = gs.text.table_rows ("GS_LOOP_METHODS");
  words = table(:,1)';
  if (! (ischar (word) && any (strcmp (word, words))))
    error ("%s: option loops %s", who, ...
           gs.text.refusal_text ("loops", strjoin (words, ", "), gs.text.shown_value (word)));
  elseif (m.sizes.nlam == 0 && m.sizes.nq == m.sizes.nu && ! strcmp (word, "index2"))
    warning ("gsmbp:option", ["%s: option loops: %s is an open chain without constraints and " ...
                              "does not use it"], who, m.name);
  endif
endfunction
