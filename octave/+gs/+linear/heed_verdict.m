## gs.linear.heed_verdict (who, m, verdict, text, row, column)
## An error of WHO where a calculation of host/linear/linear.h came to no end: TEXT, or the rate of
## the state of the number ROW has no finite derivative by COLUMN (a state, or behind these an
## input).

function heed_verdict (who, m, verdict, text, row, column)
  if (row > 0)
    error ("gsmbp:derivative", "%s: %s: %s", who, m.name, gs.text.refusal_text ( ...
        "no_derivative", ["rate of " m.states{row}], [m.states(:); m.inputs(:)]{column}));
  elseif (verdict != 0)
    error ("%s: %s: %s", who, m.name, text);
  endif
endfunction
