## D = gs.optimize.inverse_slopes (P, c, m, R, p, by)
## Derivatives of an inverse run R by the free variables of the mask BY: efforts and states; of open
## chains through the motion (M, B, C of LIN) and by parameters (INP), of closed ones by ILP;
## inputs, states of devices and outputs where CMJ is there.

function D = inverse_slopes (P, c, m, R, p, by)
  d = m.sizes;
  n = numel (p);
  nt = numel (R.t);
  D.tau = zeros (nt, columns (R.tau), n);
  D.x = zeros (nt, d.nx, n);
  D.lambda = zeros (nt, d.nlam, n);
  D.v = zeros (nt, d.nv, n);
  D.y = zeros (nt, d.ny, n);
  planned = 1:d.nu;
  if (d.nlam > 0)
    planned = m.actuated(:)';
  endif
  Q = moved (P, c, R.t, p, by, numel (planned), max (2, m.order));
  known = cellstr (m.json.sensitivity);
  [is_column, column] = ismember ({P.free.name}, known);
  is_column &= by;
  for i = 1:nt
    given = reshape (Q(:,i,:,:), numel (planned), size (Q, 3), n);
    one = given(:,1:3,:);
    motion = [R.q(i,:)', R.u(i,:)', R.ud(i,:)'];
    S = zeros (numel (known), n);
    S(sub2ind (size (S), column(is_column), find (is_column))) = 1;
    if (d.nlam > 0)
      [one, T, L] = gs.linear.loop_slopes (P.who, m, R.t(i), motion, R.tau(i,:), R.lambda(i,:), ...
                                           planned, one, S);
      D.lambda(i,:,:) = reshape (L, 1, d.nlam, n);
    else
      T = of_tree (m, R.t(i), motion, one, is_column, column);
    endif
    D.tau(i,:,:) = reshape (T, 1, rows (T), n);
    D.x(i,1:2*d.nu,:) = reshape (one(:,1:2,:), 1, 2 * d.nu, n);
    if (any (strcmp (m.subroutines, "cmj")))
      D = through_drives (D, m, R, i, [reshape(given, [], n); S]);
    endif
  endfor
endfunction

## inputs, states of devices and outputs of row I by what CMJ is by
function D = through_drives (D, m, R, i, given)
  d = m.sizes;
  n = columns (given);
  x = R.x(i,:)';
  [VJ, XJ] = m.cmj (R.t(i), R.qj(:,:,i), x(2*d.nu+1:end));
  D.v(i,:,:) = reshape (VJ * given, 1, d.nv, n);
  D.x(i,2*d.nu+1:end,:) = reshape (XJ * given, 1, d.nx - 2 * d.nu, n);
  if (d.ny > 0 && all (ismember ({"jac", "oup"}, m.subroutines)))
    [~, ~, Cx, Cv] = m.jac (R.t(i), x, R.v(i,:)');
    by = m.oup (R.t(i), x, R.v(i,:)') * given(end-numel (cellstr (m.json.sensitivity))+1:end,:);
    D.y(i,:,:) = reshape (Cx * reshape (D.x(i,:,:), d.nx, n) + Cv * (VJ * given) + by, 1, d.ny, n);
  endif
endfunction

function T = of_tree (m, t, motion, one, is_column, column)
  n = size (one, 3);
  args = num2cell (motion, 1);
  [M, B, C] = m.lin (t, args{:});
  part = @(k) reshape (one(:,k,:), m.sizes.nu, n);
  T = C * part (1) + B * part (2) + M * part (3);
  if (any (is_column))
    T(:,is_column) += m.inp (t, args{:})(:,column(is_column));
  endif
endfunction

## the motion with its derivatives, K of them, by the variables on which it depends
function Q = moved (P, c, t, p, by, nu, k)
  Q = zeros (nu, numel (t), k + 1, numel (p));
  if (! gs.optimize.is_of_values (c.args{1}))
    return;
  endif
  at = @(p) gsmbp_evaluate (c.args{1}(gs.optimize.values_struct (P, p)), t, k);
  for j = find (by)
    Q(:,:,:,j) = gs.optimize.value_slope (P, j, @(s) at (gs.optimize.replace_value (p, j, s)), ...
                                          p(j));
  endfor
endfunction
