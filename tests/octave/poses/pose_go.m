## T = pose_go (P): the placement (4 x 4) of a frame shifted to the point P.

function T = pose_go (p)
  T = eye (4);
  T(1:3, 4) = p;
end
