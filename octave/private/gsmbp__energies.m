## e = gsmbp__energies (m, t, x, v)
## What m.ene gives along a motion, five columns, a row for each time; V empty: without inputs.

function e = gsmbp__energies (m, t, x, v)
  e = m.module ("energies", m.cst, numel (t), t(:), x, v)';
endfunction
