## c = gs.control.state_feedback (who, p, o, method)
## A feedback of states of the plant P, of inputs on their way and of integrals, best ("lqr",
## "lqg") or with given poles ("place"), with what tells the states (O.observer): its gains and
## matrices.

function c = state_feedback (who, p, o, method)
  [F, H] = gs.control.late_inputs (p);
  n = rows (p.A);
  [N, nu] = size (H);
  ni = numel (p.followed) * ! isempty (o.integral);
  T = [p.C(p.followed(1:ni),:), zeros(ni, N - n)];
  step = merge (p.h > 0, p.h, 1);
  F = [F, zeros(N, ni); -step * T, (p.h > 0) * eye(ni)];
  H = [H; zeros(ni, nu)];
  if (strcmp (method, "place"))
    poles = in_plane (who, "poles", o.poles, p.h);
    K = late_place (who, p, F, H, poles);
  else
    Q = blkdiag (gs.given.weight_matrix (who, "Q", o.Q, n, 0), zeros (N - n), ...
                 gs.given.weight_matrix (who, "Qi", o.Qi, ni, 1));
    K = gs.control.riccati_solution (who, F, H, Q, gs.given.weight_matrix (who, "R", o.R, nu, ...
                                                                           1), p.h);
    poles = eig (F - H * K);
  endif
  c = struct ("K", K, "L", []);
  c.states = [p.states; strcat("u", strtrim (cellstr (num2str ((1:N-n)')))(1:N-n)); ...
              strcat("integral of ", p.measured(p.followed(1:ni)))];
  law = observer (who, p, o, method, poles);
  c.L = law.L;
  prefilter = zeros (nu, numel (p.followed));
  if (! isempty (o.track))
    prefilter = to_follow (who, p, F, H, K);
  endif
  c = composed (p, c, law, K, prefilter, ni, poles);
endfunction

## poles as they stand in the plane of a sampled system
function z = in_plane (who, option, s, h)
  if (! (isnumeric (s) && ! isempty (s) && all (isfinite (s(:)))))
    error ("%s: option %s: expected poles [1/s], found %s", who, option, gs.text.shown_value (s));
  endif
  s = double (s(:));
  if (! all (real (s) < 0))
    error ("%s: option %s: expected poles with negative real parts, found %s", who, option,
           gs.text.pole_text (s(real (s) >= 0), 0));
  endif
  if (norm (sort (imag (s)) + flipud (sort (imag (s)))) > 1e-12 * norm (s))
    error ("%s: option %s: expected complex poles in conjugate pairs, found %s", who, option, ...
           gs.text.shown_value (s.'));
  endif
  z = s;
  if (h > 0)
    z = exp (h * s);
  endif
endfunction

## inputs on their way keep their poles at z = 0
function K = late_place (who, p, F, H, poles)
  late = p.count * columns (H);
  if (numel (poles) != rows (F) - late)
    error ("%s: option poles: expected %d poles, a state or integral each, found %d", who, ...
           rows (F) - late, numel (poles));
  endif
  K = gs.control.placed_poles (who, F, H, [poles; zeros(late, 1)]);
endfunction

## how the states follow from what is measured: xh = X z + Y dy, next z = Z z + E dy + U (inputs and
## those on their way), z' where h = 0
function law = observer (who, p, o, method, poles)
  [ny, n] = size (p.C);
  word = o.observer;
  all_seen = rank (p.C) == n;
  if (isempty (word))
    word = {"full", "none"}{1 + all_seen};
  endif
  if (strcmp (method, "lqg"))
    word = "kalman";
  endif
  law = struct ("L", [], "X", zeros (n, 0), "Y", zeros (n, ny), "Z", [], "E", zeros (0, ny), ...
                "U", zeros (0, columns (p.B) * (1 + p.count)));
  if (strcmp (word, "none"))
    if (! all_seen)
      error (["%s: option observer: \"none\" needs all %d states from what is measured (%s): " ...
              "that tells %d"], who, n, strjoin (p.measured', ", "), rank (p.C));
    endif
    law.Y = pinv (p.C);
    return;
  endif
  switch (word)
    case "kalman"
      [L, M] = kalman_gain (who, p, o);
    case "full"
      L = gs.control.placed_poles (who, p.F', p.C', left_of (who, o, p, poles, n))';
      M = L * 0;
      if (p.h > 0)
        M = p.F \ L;
      endif
    case "reduced"
      law = reduced (who, p, o, poles, law);
      return;
  endswitch
  ## the estimate takes the newest measurement in: xh = z + M (dy - C z)
  law.L = L;
  law.X = eye (n) - M * p.C;
  law.Y = M;
  law.Z = p.F - L * p.C;
  law.E = L;
  law.U = inputs_of (p, eye (n));
endfunction

## what the inputs do to the next states, times S: newest first, then those on their way
function U = inputs_of (p, S)
  nu = columns (p.B);
  U = zeros (rows (S), nu * (1 + p.count));
  U(:,p.whole * nu + (1:nu)) = S * p.H0;
  if (p.count > p.whole)
    U(:,(p.whole + 1) * nu + (1:nu)) = S * p.H1;
  endif
endfunction

## those that are asked for, or three times as far left as the slowest of the closed poles
function z = left_of (who, o, p, poles, n)
  if (! isempty (o.observer_poles))
    z = in_plane (who, "observer_poles", o.observer_poles, p.h);
    if (numel (z) != n)
      error ("%s: option observer_poles: expected %d poles, found %d", who, n, numel (z));
    endif
    return;
  endif
  s = poles(abs (poles) > 1e-9 | p.h == 0);
  if (p.h > 0)
    s = log (s) / p.h;
  endif
  [~, order] = sort (real (s), "descend");
  s = 3 * s(order);
  s = real (s(1:n)) - 1e-2 * abs (s(1)) * (0:n-1)';   # real ones, all different
  z = s;
  if (p.h > 0)
    z = exp (p.h * s);
  endif
endfunction

function [L, M] = kalman_gain (who, p, o)
  [ny, n] = size (p.C);
  W = gs.given.weight_matrix (who, "W", o.W, n, 0);
  V = gs.given.weight_matrix (who, "V", o.V, ny, 1);
  M = zeros (n, ny);
  if (p.h == 0)
    L = gs.control.riccati_solution (who, p.A', p.C', W, V, 0)';
    return;
  endif
  X = expm ([-p.A, W; zeros(n), p.A'] * p.h);   # Van Loan
  W = X(n+1:end,n+1:end)' * X(1:n,n+1:end);
  L = gs.control.riccati_solution (who, p.F', p.C', (W + W') / 2, V, p.h)';
  M = p.F \ L;
endfunction

## Luenberger: [y; w] = T x, an estimate of w = N' x - L y
function law = reduced (who, p, o, poles, law)
  [ny, n] = size (p.C);
  N = null (p.C);
  if (rank (p.C) < ny || columns (N) == 0)
    error (["%s: option observer: \"reduced\": expected measurements that are independent, and " ...
            "fewer than states"], who);
  endif
  T = [p.C; N'];
  A = T * p.F / T;
  [y, w] = deal (1:ny, ny + 1:n);
  L = gs.control.placed_poles (who, A(w,w)', A(y,w)', left_of (who, o, p, poles, n - ny))';
  S = [-L, eye(n - ny)];
  law.L = L;
  law.Z = A(w,w) - L * A(y,w);
  law.E = S * A(:,y) + law.Z * L;
  law.U = inputs_of (p, S * T);
  law.X = T \ [zeros(ny, n - ny); eye(n - ny)];
  law.Y = T \ [eye(ny); L];
endfunction

## the constant gain that brings what is followed to its reference
function G = to_follow (who, p, F, H, K)
  C = [p.C(p.followed,:), zeros(numel (p.followed), rows (F) - rows (p.A))];
  E = (p.h > 0) * eye (rows (F)) - F + H * K;
  G = C * (E \ H);
  if (rank (G, 1e-9 * max (norm (G), realmin)) < rows (G))
    error (["%s: option track: the inputs cannot hold %s at any value: there are fewer of " ...
            "them, or a zero at rest"], who, strjoin (p.measured(p.followed)', ", "));
  endif
  G = pinv (G);
endfunction

## controller of states z of the observer, inputs on their way, integrals; e = [dy; dr]
function c = composed (p, c, law, K, prefilter, ni, poles)
  [n, nu] = size (p.B);
  ny = rows (p.C);
  nr = numel (p.followed);
  nz = rows (law.Z);
  nl = p.count * nu;
  Kx = K(:,1:n);
  C = [-Kx * law.X, -K(:,n+1:end)];
  D = [-Kx * law.Y, prefilter];
  N = nz + nl + ni;
  [A, B, U] = deal (zeros (N), zeros (N, ny + nr), zeros (N, nu));
  A(1:nz,1:nz) = law.Z;
  A(1:nz,nz + (1:nl)) = law.U(:,nu + 1:end);
  B(1:nz,1:ny) = law.E;
  U(1:nz,:) = law.U(:,1:nu);
  if (nl > 0)
    U(nz + (1:nu),:) = eye (nu);
    A(nz + (nu + 1:nl),nz + (1:nl - nu)) = eye (nl - nu);
  endif
  own = nz + nl + (1:ni);
  step = merge (p.h > 0, p.h, 1);
  A(own,own) = (p.h > 0) * eye (ni);
  B(own,p.followed(1:ni)) -= step * eye (ni);
  B(own,ny + (1:ni)) = step * eye (ni);
  [c.A, c.B, c.C, c.D, c.G] = deal (A + U * C, B + U * D, C, D, U);
  if (ni > 0)
    c.G(own,:) = winding (K(:,end - ni + 1:end), p.h, poles);
  endif
endfunction

## integrals drawn back where the output is limited, as fast as the slowest closed pole
function G = winding (Ki, h, poles)
  if (h > 0)
    part = 1 - max (abs (poles));
  else
    part = -max (real (poles));
  endif
  G = -part * pinv (Ki);
endfunction
