## list = gs.start.range_margins (m, t, x, v)
## The margins of the devices of the model M (m.state_margins, above 0 where the device's laws
## hold) that are passed at the times T in the states X under the inputs V (a row for each
## time): a struct array with "text" of the margin, its first "time", its "least" value, and the
## sentence "said", with the states and parameters that it is made of (host/margins.c).

function list = range_margins (m, t, x, v)
  list = struct ("text", {}, "time", {}, "least", {}, "said", {});
  if (! any (strcmp (m.subroutines, "mar")))
    return;
  endif
  [k, first, least, said] = m.module ("passed margins", m.cst, numel (t), t(:), x, v, ...
                                      gs.model.parameter_values (m), m.nominal);
  list = struct ("text", m.state_margins(k)(:)', "time", num2cell (t(first)(:)'), ...
                 "least", num2cell (least), "said", said);
endfunction
