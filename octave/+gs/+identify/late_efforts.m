## list = gs.identify.late_efforts (m, data, w)
## Sentences of the efforts of measured DATA that are late or early against the motion.  W: what
## gs.identify.regression_rows gives.  An effort that is late by T is to first degree its own value
## less T times its rate, so that T is the factor of a further column, the rate of the estimated
## effort.
## Dry and viscous friction, inertia and a constant in every joint, which the model may lack, are
## let to explain the rest first.

function list = late_efforts (m, data, w)
  list = {};
  [n, nt, t] = deal (m.sizes.nu, numel (data.t), data.t(:));
  if (nt < 20 || any (diff (t) <= 0) || columns (w.Y) == 0)
    return;
  endif
  own = 1:n*nt;
  by_time = @(x) reshape (x, n, nt)';
  known = reshape (w.measured(own) - w.b(own), n, nt);   # what the efforts hold beside Y*p
  rms = @(x) sqrt (sumsq (by_time (x)) / nt);
  s = rms (w.b(own) - w.Y(own,:) * (w.Y(own,:) \ w.b(own)))' + realmin;
  Q = basis (w.Y(own,:), data, s, n);
  step = median (diff (t));
  [late, by, doubt] = deal (zeros (1, n), zeros (1, n), Inf (1, n));   # efforts may be zero
  for turn = 1:4
    tau = moved (data.tau, t, late);
    b = ((tau' - known) ./ s)(:);
    r = b - Q * (Q' * b);
    rms_ = rms (r);
    if (turn == 1)
      before = rms_;
    elseif (turn == 4)
      break;
    endif
    estimated = tau - by_time (r) .* s';
    for g = find (any (data.tau != 0, 1))
      c = zeros (n, nt);
      c(g,:) = -central (estimated(:,g)) ./ central (t) / s(g);
      c = c(:) - Q * (Q' * c(:));
      by(g) = (c' * r) / (c' * c + realmin);
      doubt(g) = rms_(g) / (norm (c) + realmin);
    endfor
    if (turn == 1)
      certain = abs (by) > 5 * doubt;
    endif
    late += by .* certain;
  endfor
  for g = find (certain & abs (late) > 0.5 * step & rms_ < 0.95 * before)
    list{end+1} = sprintf (["effort.%s is %s by %.3g s (%.3g samples) against the motion: " ...
                            "shifted, its residual is %.2g of what it is now"], ...
                           m.coordinates{g}, {"late", "early"}{1 + (late(g) < 0)}, ...
                           abs (late(g)), abs (late(g)) / step, rms_(g) / before(g));
  endfor
endfunction

## differences between the neighbours of each; at the ends to the one
function d = central (x)
  d = [x(2) - x(1); x(3:end) - x(1:end-2); x(end) - x(end-1)];
endfunction

## an orthonormal basis of the columns of Y and of what joints may have beside the model, in rows
## divided by S
function Q = basis (Y, data, s, n)
  for g = 1:n
    u = data.u(:,g);
    own{g} = kron ([u, sign(u), data.ud(:,g), ones(size (u))], ((1:n) == g)');
  endfor
  A = [Y, own{:}] ./ kron (ones (rows (data.u), 1), s);
  A ./= norm (A, "columns") + realmin;
  [U, S, ~] = svd (A, "econ");
  Q = U(:,diag (S) > 1e-8 * S(1));
endfunction

## efforts as they would be without their delays
function tau = moved (tau, t, late)
  for g = find (late != 0)
    at = min (max (t + late(g), t(1)), t(end));
    tau(:,g) = interp1 (t, tau(:,g), at);
  endfor
endfunction
