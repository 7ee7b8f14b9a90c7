## D = gsmbp__inverse_by (P, c, m, R, p, by)
## Derivatives of an inverse run R of an open chain by the free variables of the mask BY: efforts
## through the motion (M, B, C of LIN) and by parameters (INP); of the coordinates and speeds.

function D = gsmbp__inverse_by (P, c, m, R, p, by)
  d = m.sizes;
  n = numel (p);
  nt = numel (R.t);
  D.tau = zeros (nt, d.nu, n);
  D.x = zeros (nt, d.nx, n);
  Q = moved (P, c, R.t, p, by, d.nu);
  known = cellstr (m.json.sensitivity);
  [is_column, column] = ismember ({P.free.name}, known);
  is_column &= by;
  for i = 1:nt
    [q, u, ud] = deal (R.q(i,:)', R.u(i,:)', R.ud(i,:)');
    [M, B, C] = m.lin (R.t(i), q, u, ud);
    one = reshape (Q(:,i,:,:), d.nu, 3, n);
    T = C * reshape (one(:,1,:), d.nu, n) + B * reshape (one(:,2,:), d.nu, n) ...
        + M * reshape (one(:,3,:), d.nu, n);
    if (any (is_column))
      T(:,is_column) += m.inp (R.t(i), q, u, ud)(:,column(is_column));
    endif
    D.tau(i,:,:) = reshape (T, 1, d.nu, n);
    D.x(i,1:2*d.nu,:) = reshape (one(:,1:2,:), 1, 2 * d.nu, n);
  endfor
endfunction

## coordinates, speeds, accelerations by the variables on which the motion depends
function Q = moved (P, c, t, p, by, nu)
  Q = zeros (nu, numel (t), 3, numel (p));
  if (! gsmbp__of_values (c.args{1}))
    return;
  endif
  at = @(p) gsmbp_evaluate (c.args{1}(gsmbp__as_struct (P, p)), t, 2);
  for k = find (by)
    Q(:,:,:,k) = gsmbp__slope (@(s) at (gsmbp__moved (p, k, s)), P.free(k), p(k));
  endfor
endfunction
