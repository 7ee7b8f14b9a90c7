## t = gs.plan.turning_spline (R, knots)
## Rotations through R (3 x 3 x k) at the KNOTS with continuous angular velocity and acceleration,
## the latter zero at both ends; from one to the next where there are two (slerp).  In each piece
## R(:,:,i)*exp (r), r a cubic in the way from its knot.  T: R, knots, between (rotation vectors
## from one to the next), coefs (3 x 3 x k-1, of the powers 1, 2, 3).
## Source: the angular velocities at the knots by Newton's method, as for a spline of numbers; see
## Kang and Park, Int. J. Numer. Meth. Engng 46 (1999).

function t = turning_spline (R, knots)
  k = numel (knots);
  t = struct ("R", R, "knots", knots, "between", zeros (3, k - 1));
  for i = 1:k-1
    t.between(:,i) = gs.plan.rotation_vector (R(:,:,i)' * R(:,:,i+1));
  endfor
  h = diff (knots);
  rates = t.between ./ h;
  w = ([rates, rates(:,end)] + [rates(:,1), rates]) / 2;
  for iteration = 1:30
    [miss, t.coefs, J] = jumps (t, w, h);
    if (norm (miss, Inf) <= 1e-13 * (1 + max (abs (rates(:))) / min (h)))
      return;
    endif
    w -= reshape (J \ miss, 3, k);
  endfor
  [~, t.coefs] = jumps (t, w, h);
endfunction

## jumps of the angular acceleration at all knots, where the angular velocities there are w; coefs;
## the derivatives of the jumps by w: those of a piece are in the rows and columns of its knots
function [miss, coefs, J] = jumps (t, w, h)
  n = numel (h);
  coefs = zeros (3, 3, n);
  miss = zeros (3, n + 1);
  blocks = zeros (6, 6, n);
  for i = 1:n
    r = t.between(:,i);
    back = inv (gs.plan.turning_rate (r));
    last = back * w(:,i+1);
    square = (3 * r / h(i) - 2 * w(:,i) - last) / h(i);
    cube = (w(:,i) + last - 2 * r / h(i)) / h(i)^2;
    coefs(:,:,i) = [w(:,i), square, cube];
    [A, ends, slope] = gs.plan.turning_rate (r, last, 2 * square + 6 * cube * h(i));
    miss(:,i:i+1) += [2 * square, -ends];
    blocks(:,:,i) = [-4 / h(i) * eye(3), -2 / h(i) * back
                     -2 / h(i) * A, -(4 / h(i) * A + slope) * back];
  endfor
  miss = miss(:);
  at = (1:6)' + 3 * (0:n-1);
  from = repmat (reshape (at, 6, 1, n), 1, 6);
  J = sparse (from(:), permute (from, [2, 1, 3])(:), blocks(:), 3 * n + 3, 3 * n + 3);
endfunction
