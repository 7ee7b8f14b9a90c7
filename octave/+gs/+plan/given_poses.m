## [P, R] = gs.plan.given_poses (who, m, P, R)
## Poses as places, 3 x k, and rotation matrices, 3 x 3 x k.  R: rotation matrices, Euler
## parameters (4 x k, scalar first) or [] (then unit matrices).  What is of another size or no
## rotation (host/reach/reach.h) is an error of WHO.

function [P, R] = given_poses (who, m, P, R)
  if (! (isnumeric (P) && isreal (P) && rows (P) == 3 && ndims (P) == 2 && all (isfinite (P(:)))))
    error ("%s: places: expected 3 x k finite numbers [m], found %s", who, gs.text.shown_value (P));
  endif
  k = columns (P);
  if (isempty (R))   # no poses, too
    R = repmat (eye (3), 1, 1, k);
    return;
  endif
  if (! (isnumeric (R) && isreal (R) && all (isfinite (R(:)))))
    error ("%s: axes: expected finite numbers, found %s", who, gs.text.shown_value (R));
  endif
  if (! isequal (size (R), [4, k]) ...
        && ! isequal ([size(R), ones(1, 3 - ndims (R))], [3, 3, k]))
    error (["%s: axes: expected 3 x 3 x %d (rotation matrices), 4 x %d (Euler parameters)", ...
            " or [], found %s"], who, k, k, strjoin (cellstr (num2str (size (R)'))', " x "));
  endif
  R = reshape (m.module ("axes", reshape (R, [], k)), 3, 3, k);
endfunction
