## [R, D] = gs.optimize.position_case (P, m, c, args, options, p, by)
## Positions at rest, one after the other: ARGS are the names of the coordinates that are held and
## their values, a row for each position; loops are closed along the way.  Efforts are those that
## hold them.  D: derivatives by the free variables of the mask BY.

function [R, D] = position_case (P, m, c, args, options, p, by)
  d = m.sizes;
  names = cellstr (args{1});
  held = cellfun (@(name) find (strcmp (m.coordinates, name)), names(:)');
  values = rowwise (c, args{2}, numel (held));
  n = rows (values);
  o = gs.given.call_options ("gsmbp_optimize", {"guess", m.initial(1:d.nq), "numbers"}, options);
  R = struct ("t", (1:n)', "x", zeros (n, d.nx), "v", zeros (n, d.nv), "extra", struct ());
  q = o.guess(:);
  for i = 1:n
    q = position (m, q, held, values(i,:)');
    R.x(i,:) = [q; zeros(d.nu, 1); m.initial(d.nq+d.nu+1:end)]';
    if (d.nlam > 0 && any (strcmp (m.subroutines, "inl")))
      [R.tau(i,:), R.lambda(i,:)] = m.inl (0, q, zeros (d.nu, 1), zeros (d.nu, 1));
    elseif (any (strcmp (m.subroutines, "inv")))
      R.tau(i,:) = m.inv (0, q, zeros (d.nu, 1), zeros (d.nu, 1));
    endif
  endfor
  R.y = gs.run.output_values (m, zeros (n, 1), R.x, R.v);
  R = gs.model.named_results (m, R);
  D = struct ();
  if (any (by))
    D = derivatives (P, m, c, R, p, by, held);
  endif
endfunction

function values = rowwise (c, values, n)
  if (! (isnumeric (values) && isreal (values) && all (isfinite (values(:)))))
    error (["gsmbp_optimize: case %s: expected finite numbers, a row for each position, " ...
            "found %s"], c.name, gs.text.shown_value (values));
  elseif (n == 1)
    values = values(:);
  elseif (columns (values) != n)
    error (["gsmbp_optimize: case %s: expected %d columns of values (held coordinates), " ...
            "found %d"], c.name, n, columns (values));
  endif
endfunction

## the coordinates with those that are held at their values
function q = position (m, q, held, values)
  d = m.sizes;
  if (d.nlam == 0)
    q(held) = values;
  elseif (isequal (sort (held(:)), sort (m.actuated(:))))
    [planned, order] = sort (held(:));
    jet = gs.plan.whole_motion ("gsmbp_optimize", m, values(order)(:), planned, 0, q);
    q = jet(:,1);
  else
    q(held) = values;
    q = gsmbp_assemble (m, q, "hold", m.coordinates(held))(1:d.nq);
  endif
endfunction

function D = derivatives (P, m, c, R, p, by, held)
  d = m.sizes;
  n = numel (p);
  K = numel (R.t);
  V = zeros (K, numel (held), n);
  if (gs.optimize.is_of_values (c.args{2}))
    at = @(p) rowwise (c, c.args{2}(gs.optimize.values_struct (P, p)), numel (held));
    for k = find (by)
      V(:,:,k) = gs.optimize.value_slope (P, k, @(s) at (gs.optimize.replace_value (p, k, s)), ...
                                          p(k));
    endfor
  endif
  [has, column] = ismember ({P.free.name}, cellstr (m.json.sensitivity));
  has &= by;
  D = struct ("x", zeros (K, d.nx, n), "y", zeros (K, d.ny, n), "tau", zeros (K, d.nu, n));
  by_loops = d.nlam > 0 && isfield (R, "tau") && any (strcmp (m.subroutines, "ilp"));
  if (d.nlam > 0)
    D = rmfield (D, "tau");
  endif
  if (by_loops)
    D.tau = zeros (K, d.nact, n);
    D.lambda = zeros (K, d.nlam, n);
  endif
  for i = 1:K
    x = R.x(i,:)';
    dq = zeros (d.nq, n);
    dq(held,:) = reshape (V(i,:,:), numel (held), n);
    dq = followed (m, x, dq, held, has, column);
    D.x(i,1:d.nq,:) = reshape (dq, 1, d.nq, n);
    if (d.ny > 0 && all (ismember ({"jac", "oup"}, m.subroutines)))
      [~, ~, C] = m.jac (0, x);
      Y = C(:,1:d.nq) * dq;
      Y(:,has) += m.oup (0, x)(:,column(has));
      D.y(i,:,:) = reshape (Y, 1, d.ny, n);
    endif
    if (d.nlam == 0 && all (ismember ({"lin", "inp"}, m.subroutines)))
      still = zeros (d.nu, 1);
      [~, ~, C] = m.lin (0, x(1:d.nq), still, still);
      T = C * dq;
      T(:,has) += m.inp (0, x(1:d.nq), still, still)(:,column(has));
      D.tau(i,:,:) = reshape (T, 1, d.nu, n);
    elseif (by_loops)
      [T, L] = by_ilp (m, x, R.tau(i,:), R.lambda(i,:), dq, has, column);
      D.tau(i,:,:) = reshape (T, 1, d.nact, n);
      D.lambda(i,:,:) = reshape (L, 1, d.nlam, n);
    endif
  endfor
endfunction

## efforts and multipliers of a closed chain at rest, whose coordinates change by DQ
function [T, L] = by_ilp (m, x, tau, lam, dq, has, column)
  d = m.sizes;
  n = columns (dq);
  P = zeros (numel (cellstr (m.json.sensitivity)), n);
  P(sub2ind (size (P), column(has), find (has))) = 1;
  planned = m.actuated(:)';
  Q = zeros (numel (planned), 3, n);
  Q(:,1,:) = reshape (dq(planned,:), numel (planned), 1, n);
  motion = [x(1:d.nq), zeros(d.nu, 2)];
  [~, T, L] = gs.linear.loop_slopes ("gsmbp_optimize", m, 0, motion, tau, lam, planned, Q, P);
endfunction

## the coordinates that follow so that the loops stay closed
function dq = followed (m, x, dq, held, has, column)
  if (m.sizes.nlam == 0)
    return;
  endif
  others = setdiff (1:m.sizes.nq, held);
  DP = m.tan (0, x);
  PP = zeros (rows (DP), columns (dq));
  PP(:,has) = m.cop (0, x)(:,column(has));
  rows_ = any (DP != 0, 2);
  dq(others,:) = -DP(rows_,others) \ (PP(rows_,:) + DP(rows_,held) * dq(held,:));
endfunction
