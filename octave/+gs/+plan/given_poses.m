## [P, R] = gs.plan.given_poses (who, P, R)
## Poses as places, 3 x k, and rotation matrices, 3 x 3 x k.  R: rotation matrices, Euler
## parameters (4 x k, scalar first) or [] (then unit matrices).  What is of another size or no
## rotation is an error of WHO.

function [P, R] = given_poses (who, P, R)
  if (! (isnumeric (P) && isreal (P) && rows (P) == 3 && ndims (P) == 2 && all (isfinite (P(:)))))
    error ("%s: places: expected 3 x k finite numbers [m], found %s", who, gs.text.shown_value (P));
  endif
  k = columns (P);
  if (isempty (R))
    R = repmat (eye (3), 1, 1, k);
    return;
  endif
  if (! (isnumeric (R) && isreal (R) && all (isfinite (R(:)))))
    error ("%s: axes: expected finite numbers, found %s", who, gs.text.shown_value (R));
  endif
  if (isequal (size (R), [4, k]))
    R = by_parameters (who, R);
  endif
  if (! isequal ([size(R), ones(1, 3 - ndims (R))], [3, 3, k]))
    error (["%s: axes: expected 3 x 3 x %d (rotation matrices), 4 x %d (Euler parameters)", ...
            " or [], found %s"], who, k, k, strjoin (cellstr (num2str (size (R)'))', " x "));
  endif
  for i = 1:k
    miss = max (max (abs (R(:,:,i)' * R(:,:,i) - eye (3))));
    if (miss > 1e-6 || det (R(:,:,i)) < 0)
      error ("%s: axes of pose %d: expected a rotation matrix, found R'R - 1 up to %g, det %g", ...
             who, i, miss, det (R(:,:,i)));
    endif
    [U, ~, V] = svd (R(:,:,i));   # rounded decimals: the closest rotation
    R(:,:,i) = U * V';
  endfor
endfunction

## rotation matrices of Euler parameters, which need not have the norm 1
function R = by_parameters (who, e)
  s = sqrt (sumsq (e));
  if (any (s < 1e-6))
    error ("%s: axes: Euler parameters of pose %d are zero", who, find (s < 1e-6, 1));
  endif
  e ./= s;
  for i = columns (e):-1:1
    v = e(2:4,i);
    X = [0, -v(3), v(2); v(3), 0, -v(1); -v(2), v(1), 0];
    R(:,:,i) = eye (3) + 2 * e(1,i) * X + 2 * X * X;
  endfor
endfunction
