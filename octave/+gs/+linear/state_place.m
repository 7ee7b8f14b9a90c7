## at = gs.linear.state_place (m, t, x, v)
## The state X of the model M at the time T under the inputs V as the calculations of host/linear
## take it (asked_place of glue/linear.h): a cell array.

function at = state_place (m, t, x, v)
  units = arrayfun (@(k) strtrim (gs.text.constraint_unit (m, k)), 1:m.sizes.nlam, ...
                    "UniformOutput", false);
  at = {m.cst, gs.model.parameter_values(m), t, x, m.nominal, v, m.inputs, m.units.states, units};
endfunction
