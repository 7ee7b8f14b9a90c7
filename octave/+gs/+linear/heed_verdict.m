## gs.linear.heed_verdict (who, m, verdict, text)
## An error of WHO where a calculation of host/linear/linear.h came to no end.

function heed_verdict (who, m, verdict, text)
  id = {"", "", "", "", "gsmbp:derivative", "gsmbp:margin", ""}{verdict + 1};
  if (! isempty (id))
    error (id, "%s: %s: %s", who, m.name, text);
  elseif (verdict != 0)
    error ("%s: %s: %s", who, m.name, text);
  endif
endfunction
