## R = ne_turn (AXIS, ANGLE): rotation by an angle about a unit vector. R = ne_turn (E): by Euler
## parameters E (four; made a unit).

function R = ne_turn (axis, angle)
  if (nargin == 1)
    e = axis / norm (axis);
    [c, axis] = deal (e(1), e(2:4)(:));
    S = skew (axis);
    R = eye (3) + 2 * c * S + 2 * S * S;
    return;
  end
  S = skew (axis);
  R = eye (3) + sin (angle) * S + (1 - cos (angle)) * S * S;
end

function S = skew (a)
  S = [0, -a(3), a(2); a(3), 0, -a(1); -a(2), a(1), 0];
end
