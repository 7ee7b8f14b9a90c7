## q = ne_measure (JOINT, S, R, NEAR): the coordinates of a joint whose child's axes stand at
## displacement S with rotation R, the inverse of ne_freedom; what the joint forbids is overlooked.
## NEAR (optional) picks the sign of Euler parameters, the turn of angles and the start for three
## angles.

function q = ne_measure (joint, s, R, near)
  [nq, ~] = ne_sizes (joint);
  if (nargin < 4)
    near = zeros (nq, 1);
  end
  e = joint.axis;
  switch (joint.type)
    case {"prismatic"}
      q = e' * s;
    case {"revolute"}
      q = beside (angle (e, R), near);
    case {"helical"}
      q = beside (angle (e, R), e' * s / joint.pitch);   # any number of turns
    case {"cylindrical"}
      q = [e' * s; beside(angle (e, R), near(2))];
    case {"universal"}
      a = R * joint.second;
      q = beside (atan2 (ne_cross (e, joint.second)' * a, joint.second' * a), near(1));
      q(2, 1) = beside (angle (joint.second, ne_turn (e, q)' * R), near(2));
    case {"planar"}
      first = e([3, 1, 2]);
      q = [first' * s; ne_cross(e, first)' * s; beside(angle (e, R), near(3))];
    case {"spherical"}
      q = turns (joint, R, near);
    case {"free"}
      q = [s; turns(joint, R, near(4:end))];
    case {"fixed"}
      q = zeros (0, 1);
  end
end

## angle of a rotation about the unit vector e
function a = angle (e, R)
  a = atan2 (e' * [R(3, 2) - R(2, 3); R(1, 3) - R(3, 1); R(2, 1) - R(1, 2)], trace (R) - 1);
end

function a = beside (a, near)
  a += 2 * pi * round ((near - a) / (2 * pi));
end

function q = turns (joint, R, near)
  if (isempty (joint.orientation))
    q = parameters (R);
    q *= 1 - 2 * (q' * near(:) < 0);
    return;
  end
  q = near(:);
  for step = 1:40                         # Newton on the rotation that is missing
    [~, Rq, E] = ne_freedom (setfield (joint, "type", "spherical"), q, zeros (3, 1));
    change = E(4:6, :) \ ne_vector (R * Rq');
    q += change / max (1, norm (change));
    if (norm (change) < 1e-15)
      break;
    end
  end
end

## Euler parameters of a rotation, the largest one found first
function e = parameters (R)
  squares = [1 + trace(R), 1 + 2 * diag(R)' - trace(R)];
  [~, k] = max (squares);
  products = [squares(1), R(3, 2) - R(2, 3), R(1, 3) - R(3, 1), R(2, 1) - R(1, 2);
              R(3, 2) - R(2, 3), squares(2), R(1, 2) + R(2, 1), R(1, 3) + R(3, 1);
              R(1, 3) - R(3, 1), R(1, 2) + R(2, 1), squares(3), R(2, 3) + R(3, 2);
              R(2, 1) - R(1, 2), R(1, 3) + R(3, 1), R(2, 3) + R(3, 2), squares(4)];
  e = products(:, k) / norm (products(:, k));
end
