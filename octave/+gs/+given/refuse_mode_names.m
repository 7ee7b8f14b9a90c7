## gs.given.refuse_mode_names (who, what, m, given)
## An error of WHO about WHAT where one of the names in GIVEN (a list, {name, value, ...} or a
## struct) is that of the mode of an event of the model M: no input, though it has a slot in v.

function refuse_mode_names (who, what, m, given)
  if (isstruct (given))
    given = fieldnames (given);
  endif
  given = cellstr (given(cellfun (@ischar, given)));
  modes = [m.events(:).input];
  modes = modes(modes > 0);
  alike = @(names) strrep (names, ".", "_");
  k = find (ismember (alike (m.inputs(modes)), alike (given)), 1);
  if (! isempty (k))
    inputs = strjoin (m.inputs(gs.model.free_inputs (m)), ", ");
    error (["%s: %s: %s is the mode of an event (0: holds, -1 or 1: slips), no input; expected " ...
            "inputs (%s); a run sets modes itself, from option \"modes\" of gsmbp_simulate on; " ...
            "gsmbp_trim and gsmbp_linear take them in v"], who, what, m.inputs{modes(k)}, inputs);
  endif
endfunction
