## D = gsmbp__inverse_by (P, c, m, R, p, by)
## Derivatives of an inverse run R by the free variables of the mask BY: efforts and states; of open
## chains through the motion (M, B, C of LIN) and by parameters (INP), of closed ones by ILP.

function D = gsmbp__inverse_by (P, c, m, R, p, by)
  d = m.sizes;
  n = numel (p);
  nt = numel (R.t);
  D.tau = zeros (nt, columns (R.tau), n);
  D.x = zeros (nt, d.nx, n);
  D.lambda = zeros (nt, d.nlam, n);
  planned = 1:d.nu;
  if (d.nlam > 0)
    planned = m.actuated(:)';
  endif
  Q = moved (P, c, R.t, p, by, numel (planned));
  known = cellstr (m.json.sensitivity);
  [is_column, column] = ismember ({P.free.name}, known);
  is_column &= by;
  for i = 1:nt
    one = reshape (Q(:,i,:,:), numel (planned), 3, n);
    motion = [R.q(i,:)', R.u(i,:)', R.ud(i,:)'];
    if (d.nlam > 0)
      S = zeros (numel (known), n);
      S(sub2ind (size (S), column(is_column), find (is_column))) = 1;
      [one, T, L] = gsmbp__loop_slopes (P.who, m, R.t(i), motion, R.tau(i,:), R.lambda(i,:), ...
                                        planned, one, S);
      D.lambda(i,:,:) = reshape (L, 1, d.nlam, n);
    else
      T = of_tree (m, R.t(i), motion, one, is_column, column);
    endif
    D.tau(i,:,:) = reshape (T, 1, rows (T), n);
    D.x(i,1:2*d.nu,:) = reshape (one(:,1:2,:), 1, 2 * d.nu, n);
  endfor
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
