## gs.model.need_checks (m)
## Stop if the model M was emitted without the routines that check other values of its parameters
## (CHK) and move its initial state with them (INI).

function need_checks (m)
  for need = {"rules", "starts"; "chk", "ini"}
    if (! isempty (gs.model.json_rows (m.json, need{1})) && ! any (strcmp (m.subroutines, need{2})))
      error ("%s: %s", m.name, gs.text.refusal_text ("unchecked", upper (need{2})));
    endif
  endfor
endfunction
