## e = gs.run.energy_sums (m, t, x, v)
## What m.ene gives along a motion, five columns, a row for each time; V empty: without inputs.

function e = energy_sums (m, t, x, v)
  e = m.module ("energies", m.cst, numel (t), t(:), x, v)';
endfunction
