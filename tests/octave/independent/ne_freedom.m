## [s, R, E, bias] = ne_freedom (JOINT, Q, U): where the coordinates Q put the child's joint axes,
## seen from the parent's joint axes: displacement s and rotation R; with the speeds U: [s'; angular
## velocity] = E U, [s''; its rate] = E U' + bias, all in the parent's joint axes.

function [s, R, E, bias] = ne_freedom (joint, q, u)
  s = w = zeros (3, 1);
  R = eye (3);
  E = zeros (6, 0);
  bias = zeros (6, 1);
  i = 1;
  for move = ne_moves (joint)
    [kind, e] = move{1}{:};
    n = columns (E);
    if (strcmp (kind, "slide"))
      s += e * q(i);
      E(:, n + 1) = [e; 0; 0; 0];
      i += 1;
    elseif (strcmp (kind, "ball"))
      R = R * ne_turn (q(i:i+3));
      E(4:6, n + (1:3)) = R;
      bias(4:6) += ne_cross (w, R * u(n + (1:3)));
      i += 4;
    else
      pitch = joint.pitch * strcmp (kind, "screw");
      s += pitch * q(i) * e;
      about = R * e;
      E(:, n + 1) = [pitch * e; about];
      bias(4:6) += ne_cross (w, about) * u(n + 1);
      w += about * u(n + 1);
      R = R * ne_turn (e, q(i));
      i += 1;
    end
  end
end
