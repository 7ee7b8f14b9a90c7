## [iopt, ropt, atol, method, order] = gs.run.integration_options (who, o, d, m, way)
## The arrays iopt and ropt of gs_integration (share/engine/core/gsmbp/options.h), the absolute
#tolerances and the # method, the largest order.  O: the options of gsmbp_simulate, D: the sizes of
#the model M, # WAY: of the loops.

function [iopt, ropt, atol, method, order] = integration_options (who, o, d, m, way)
  methods = gs.text.table_rows ("GS_METHODS");
  gs.given.check_kind (who, "option method", o.method, methods(:,1)');
  method = o.method;
  row = gs.run.method_row (method);
  if (strcmp (m.precision, "quad") && ! strcmp (row.by, "core"))
    error ("%s: method \"%s\" works in double precision; %s was built in quad", who, method, ...
           m.name);
  endif
  if (isempty (o.step))
    o.step = 1e-3 * row.fixed;
  endif
  gs.given.check_kind (who, "option step", o.step, {"nonnegative", "positive"}{1 + row.fixed});
  gs.given.check_kind (who, "option maxstep", o.maxstep, "nonnegative");
  if (row.fixed && ! isnan (o.rtol) && isempty (o.audit))
    warning ("gsmbp:option", ["%s: option rtol: method \"%s\" has steps of one length and does " ...
                              "not use it; the option \"step\" sets its error"], who, method);
  endif
  if (isnan (o.rtol))
    options = gs.text.table_rows ("GS_OPTIONS");
    o.rtol = str2double (options{strcmp (options(:,1), "rtol"),3});
  endif
  [o.rtol, atol] = gs.run.error_tolerances (who, m, o.rtol, o.atol, method);
  order = maxorder (who, o.maxorder, method, row);
  if (o.drift && ! any (strcmp (m.subroutines, "con")))
    error ("%s: option drift needs the subroutine CON, which %s was emitted without", who, m.name);
  endif
  iopt = [row.number, way, logical(o.drift), o.maxsteps, 0, 0, m.speed_rows'];
  ropt = [o.step, o.rtol, o.maxstep];
endfunction

## the largest order of a METHOD with this ROW
function order = maxorder (who, order, method, row)
  if (isempty (order))
    order = row.order;
  elseif (isempty (row.orders))
    error ("%s: option maxorder: %s", who, ...
           gs.text.refusal_text ("one_order", method, gs.text.shown_value (order)));
  elseif (! (isnumeric (order) && isscalar (order) && any (order == row.orders)))
    numbers = strjoin (arrayfun (@num2str, row.orders, "uniformoutput", false), ", ");
    error ("%s: option maxorder: %s", who, gs.text.refusal_text ("order", numbers, ...
                                                            gs.text.shown_value (order)));
  endif
endfunction
