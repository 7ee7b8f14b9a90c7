## [iopt, ropt, atol, method, order] = gs.run.integration_options (who, o, d, m, way)
## The arrays iopt and ropt of gs_run (share/engine/core/gsmbp/options.h), the absolute
#tolerances and the # method, the largest order.  O: the options of gsmbp_simulate, D: the sizes of
#the model M, # WAY: of the loops.

function [iopt, ropt, atol, method, order] = integration_options (who, o, d, m, way)
  methods = gs.text.table_rows ("GS_METHODS");
  gs.given.check_kind (who, "option method", o.method, methods(:,1)');
  method = o.method;
  number = str2double (methods{strcmp (methods(:,1), method),2});
  if (strcmp (m.precision, "quad") && ! any (strcmp (method, {"dp853", "rk4"})))
    error ("%s: method \"%s\" works in double precision; %s was built in quad", who, method, ...
           m.name);
  endif
  fixed = any (strcmp (o.method, {"rk4", "gauss"}));
  if (isempty (o.step))
    o.step = 1e-3 * fixed;
  endif
  gs.given.check_kind (who, "option step", o.step, {"nonnegative", "positive"}{1 + fixed});
  gs.given.check_kind (who, "option maxstep", o.maxstep, "nonnegative");
  if (fixed && ! isnan (o.rtol) && isempty (o.audit))
    warning ("gsmbp:option", ["%s: option rtol: method \"%s\" has steps of one length and does " ...
                              "not use it; the option \"step\" sets its error"], who, method);
  endif
  if (isnan (o.rtol))
    options = gs.text.table_rows ("GS_OPTIONS");
    o.rtol = str2double (options{strcmp (options(:,1), "rtol"),3});
  endif
  [o.rtol, atol] = gs.run.error_tolerances (who, m, o.rtol, o.atol, method);
  order = maxorder (who, o.maxorder, method);
  if (o.drift && ! any (strcmp (m.subroutines, "con")))
    error ("%s: option drift needs the subroutine CON, which %s was emitted without", who, m.name);
  endif
  iopt = [number, way, logical(o.drift), o.maxsteps, 0, 0, m.speed_rows'];
  ropt = [o.step, o.rtol, o.maxstep];
endfunction

## what the implicit methods have: BDF the orders 1 to 5, collocation of Radau and Gauss three
function order = maxorder (who, order, method)
  orders = struct ("radau", [5, 9, 13], "auto", [5, 9, 13], "gauss", [4, 6, 8]);
  if (any (strcmp (method, {"dp853", "rk4"})) && ! isempty (order))
    error ("%s: option maxorder: %s", who, ...
           gs.text.refusal_text ("one_order", method, gs.text.shown_value (order)));
  elseif (isfield (orders, method))
    orders = orders.(method);
  else
    orders = 1:5;
  endif
  if (isempty (order))
    order = orders(end - strcmp (method, "gauss"));
  endif
  if (! (isnumeric (order) && isscalar (order) && any (order == orders)))
    numbers = strjoin (arrayfun (@num2str, orders, "uniformoutput", false), ", ");
    error ("%s: option maxorder: %s", who, gs.text.refusal_text ("order", numbers, ...
                                                            gs.text.shown_value (order)));
  endif
endfunction
