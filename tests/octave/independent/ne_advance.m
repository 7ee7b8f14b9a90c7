## q = ne_advance (M, Q, DX): the coordinates after a small motion with the speeds DX for a unit of
## time: Q + DX, except that Euler parameters are turned.

function q = ne_advance (m, q, dx)
  [nq, nu] = ne_sizes (m);
  i = j = 0;
  for k = 1:numel (m.joint)
    lead = min (nq(k), nu(k));
    if (nq(k) > nu(k))
      lead = nu(k) - 3;
      e = q(i + lead + (1:4));
      v = dx(j + lead + (1:3));
      half = norm (v) / 2;
      d = [cos(half); v / 2 * sinc(half / pi)];
      q(i + lead + (1:4)) = [e(1) * d(1) - e(2:4)' * d(2:4); ...
                             e(1) * d(2:4) + d(1) * e(2:4) + ne_cross(e(2:4), d(2:4))];
    end
    q(i + (1:lead)) += dx(j + (1:lead));
    i += nq(k);
    j += nu(k);
  end
end
