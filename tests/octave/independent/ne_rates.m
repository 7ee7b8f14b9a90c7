## qd = ne_rates (M, Q, U): rates of the coordinates: U itself, except for Euler parameters e, whose
## rate is e o [0; w]/2 (w in the child's joint axes).

function qd = ne_rates (m, q, u)
  [nq, nu] = ne_sizes (m);
  qd = zeros (size (q));
  i = j = 0;
  for k = 1:numel (m.joint)
    lead = nu(k);
    if (nq(k) > nu(k))
      lead = nu(k) - 3;
      e = q(i + lead + (1:4));
      w = u(j + lead + (1:3));
      qd(i + lead + (1:4)) = [-e(2:4)' * w; e(1) * w + ne_cross(e(2:4), w)] / 2;
    end
    qd(i + (1:lead)) = u(j + (1:lead));
    i += nq(k);
    j += nu(k);
  end
end
