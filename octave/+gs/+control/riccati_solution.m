## [K, P] = gs.control.riccati_solution (who, A, B, Q, R, h)
## The gain of the best state feedback, of rates (h = 0) or of next values (h > 0): by the control
## package on balanced states of like size, then by steps of Newton's method (Kleinman).

function [K, P] = riccati_solution (who, A, B, Q, R, h)
  [S, ~] = balance (clean (A));
  d = max (abs (S), [], 2);
  S = diag (d);
  [A, B, Q] = deal (S \ A * S, S \ B, S * Q * S);
  Q = (Q + Q') / 2;
  try
    if (h > 0)
      [K, P] = dlqr (A, B, Q, R);
    else
      [K, P] = lqr (A, B, Q, R);
    endif
  catch err
    error (["%s: no gain makes the loop stable: the inputs do not reach a state that grows, or " ...
            "the weights do not see it (%s)"], who, strtrim (strrep (err.message, "\n", " ")));
  end_try_catch
  for k = 1:3
    N = improved (A, B, Q, R, K, h);
    if (isempty (N))
      break;
    endif
    K = N;
  endfor
  K = K / S;
  P = S \ P / S;
endfunction

## one step of Newton's method, empty where it does not help
function N = improved (A, B, Q, R, K, h)
  F = A - B * K;
  W = Q + K' * R * K;
  N = [];
  if (h > 0)
    if (max (abs (eig (F))) >= 1)
      return;
    endif
    P = dlyap (F', (W + W') / 2);
    N = (R + B' * P * B) \ (B' * P * A);
  else
    if (max (real (eig (F))) >= 0)
      return;
    endif
    P = lyap (F', (W + W') / 2);
    N = R \ (B' * P);
  endif
  if (! all (isfinite (N(:))))
    N = [];
  endif
endfunction

## rounding errors must not take part in the balancing
function A = clean (A)
  A(abs (A) < 1e-14 * max (abs (A(:)))) = 0;
endfunction
