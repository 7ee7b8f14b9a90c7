## c = gs.control.output_feedback (who, p, o)
## The best constant feedback u = -F y of the plant P for deviations of unit covariance at the
## start: steps of Levine and Athans with a line search, then Newton's method on the gradient.

function c = output_feedback (who, p, o)
  refuse_options (who, o);
  [A, B] = gs.control.late_inputs (p);
  [n, nu] = deal (rows (p.A), columns (B));
  q.A = A;
  q.B = B;
  q.C = [p.C, zeros(rows (p.C), rows (A) - n)];
  q.Q = blkdiag (gs.given.weight_matrix (who, "Q", o.Q, n, 0), zeros (rows (A) - n));
  q.R = gs.given.weight_matrix (who, "R", o.R, nu, 1);
  q.h = p.h;
  if (rank (q.C) < rows (q.C))
    error ("%s: the measurements %s depend on each other: expected independent ones", who,
           strjoin (p.measured', ", "));
  endif
  F = first (who, q, o, p);
  for k = 1:500
    [J, D, S] = cost (q, F);
    if (norm (D, Inf) <= 1e-6 * norm (S, Inf) || norm (S, Inf) <= 1e-7 * max (norm (F, Inf), 1e-9))
      break;
    endif
    t = 1;
    while (cost (q, F + t * S) >= J && t > 1e-10)
      t /= 2;
    endwhile
    F += t * S * (t > 1e-10);
    if (t <= 1e-10)
      break;
    endif
  endfor
  F = newton (q, F);
  c = struct ("A", [], "B", zeros (0, rows (F')), "C", zeros (nu, 0), "D", -F, ...
              "G", zeros (0, nu), "K", F * q.C, "L", [], "F", F);
  c.states = p.plant.stname;
endfunction

function refuse_options (who, o)
  given = {"integral", "track"}(! cellfun (@isempty, {o.integral, o.track}));
  if (! isempty (given))
    error (["%s: option %s: expected a method with states (lqr, lqg, place); \"output\" is a " ...
            "constant gain"], who, given{1});
  endif
endfunction

## the sum over the motion, Inf where the loop is not stable; half its gradient; a step downhill
function [J, D, S] = cost (q, F)
  Z = q.A - q.B * F * q.C;
  W = q.Q + q.C' * F' * q.R * F * q.C;
  J = Inf;
  if (worst (q, F) >= 0)
    return;
  endif
  if (q.h > 0)
    P = dlyap (Z', (W + W') / 2);
  else
    P = lyap (Z', (W + W') / 2);
  endif
  J = trace (P);
  if (nargout < 2)
    return;
  endif
  if (q.h > 0)
    L = dlyap (Z, eye (rows (Z)));
    R = q.R + q.B' * P * q.B;
    G = q.B' * P * q.A;
  else
    L = lyap (Z, eye (rows (Z)));
    R = q.R;
    G = q.B' * P;
  endif
  M = q.C * L * q.C';
  D = R * F * M - G * L * q.C';
  S = -(R \ D) / M;
endfunction

function w = worst (q, F)
  s = eig (q.A - q.B * F * q.C);
  w = max (real (s));
  if (q.h > 0)
    w = max (abs (s)) - 1;
  endif
endfunction

## a gain that stabilizes
function F = first (who, q, o, p)
  [nu, ny] = deal (columns (q.B), rows (q.C));
  tries = {};
  if (! isempty (o.start))
    if (! isequal (size (o.start), [nu ny]))
      error ("%s: option start: expected %d x %d numbers, found %s", who, nu, ny, ...
             gs.text.shown_value (size (o.start)));
    endif
    tries{end+1} = double (o.start);
  endif
  tries{end+1} = zeros (nu, ny);
  try
    tries{end+1} = gs.control.riccati_solution (who, q.A, q.B, ...
                                                q.Q + 1e-9 * norm (q.Q) * eye (rows (q.A)), ...
                                                q.R, q.h) * pinv (q.C);
  end_try_catch
  [~, k] = min (cellfun (@(F) worst (q, F), tries));
  F = tries{k};
  limits = optimset ("MaxFunEvals", 4000, "MaxIter", 4000, "TolX", 1e-8, "TolFun", 1e-8);
  if (worst (q, F) >= 0)
    F = reshape (fminsearch (@(f) worst (q, reshape (f, nu, ny)), F(:), limits), nu, ny);
  endif
  if (worst (q, F) >= 0)
    error (["%s: no constant feedback of %s was found that makes the loop stable: expected " ...
            "more measurements, or an observer (lqg, place)"], who, strjoin (p.measured', ", "));
  endif
endfunction

function F = newton (q, F)
  for k = 1:8
    [~, D] = cost (q, F);
    n = numel (F);
    H = zeros (n);
    h = 1e-5 * max (abs (F(:)), 1e-3 * max (norm (F, Inf), 1e-3));
    for i = 1:n
      e = zeros (size (F));
      e(i) = h(i);
      if (! isfinite (cost (q, F + e)) || ! isfinite (cost (q, F - e)))
        return;
      endif
      [~, up] = cost (q, F + e);
      [~, down] = cost (q, F - e);
      H(:,i) = (up - down)(:) / (2 * h(i));
    endfor
    N = F - reshape (H \ D(:), size (F));
    [J, E] = cost (q, N);
    if (! isfinite (J) || norm (E, Inf) >= norm (D, Inf))
      return;
    endif
    F = N;
  endfor
endfunction
