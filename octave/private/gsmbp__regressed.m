## w = gsmbp__regressed (who, m, d)
## The rows of a regression of the measured motion D: w.Y (rows: efforts of a time, then of the
## next; columns: base parameters), w.p (their values in the model), w.r, what the efforts hold
## beside Y*p.

function w = gsmbp__regressed (who, m, d)
  if (! any (strcmp (m.subroutines, "reg")))
    error (["%s: %s has no subroutine REG: derive it with the request regressor of " ...
            "gsmbp_fortran"], who, m.name);
  endif
  n = m.sizes.nu;
  nt = numel (d.t);
  v = zeros (m.sizes.nv, 1);
  Y = zeros (n, numel (m.json.base_parameters), nt);
  r = zeros (n, nt);
  [t, q, u, ud, reg, p] = deal (d.t, d.q', d.u', d.ud', m.reg, []);
  for k = 1:nt
    [Y(:,:,k), p, r(:,k)] = reg (t(k), q(:,k), u(:,k), ud(:,k), v);
  endfor
  w.Y = reshape (permute (Y, [1, 3, 2]), n * nt, []);
  [w.p, w.r] = deal (p, r(:));
  w.names = {m.json.base_parameters.name}';
  w.units = {m.json.base_parameters.unit}';
endfunction
