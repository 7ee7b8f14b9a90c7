## unit = gs.text.constraint_unit (m, k)
## The unit of the constraint K of M: m where its multiplier is a force; nothing where that is not
## known.

function unit = constraint_unit (m, k)
  units = {" m", " rad", ""};
  unit = units([strcmp(m.units.multipliers{k}, {"N", "N*m"}), true]){1};
endfunction
