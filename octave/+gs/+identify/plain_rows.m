## w = gs.identify.plain_rows (who, m, d)
## The rows of a regression of the measured motion D: w.Y (rows: efforts of a time, then of the
## next; columns: base parameters), w.p (their values in the model), w.r, what the efforts hold
## beside Y*p.

function w = plain_rows (who, m, d)
  if (! any (strcmp (m.subroutines, "reg")))
    error (["%s: %s has no subroutine REG: derive it with the request regressor of " ...
            "gsmbp_fortran"], who, m.name);
  endif
  [Y, p, r] = m.module ("many", "reg", m.cst, d.t(:)', d.q', d.u', d.ud', zeros (m.sizes.nv, 1));
  w.Y = reshape (permute (Y, [1, 3, 2]), numel (r), []);
  [w.p, w.r] = deal (p(:,1), r(:));
  w.names = {m.json.base_parameters.name}';
  w.units = {m.json.base_parameters.unit}';
endfunction
