## [q, u, ud] = ne_own (M, K, A): coordinates, speeds and accelerations of the freedoms of all loop
## joints, as if they were tree joints; from k = ne_rows (...) and the accelerations of the bodies
## A.

function [q, u, ud] = ne_own (m, k, a)
  q = u = ud = zeros (0, 1);
  for l = 1:numel (m.loop)
    joint = m.loop(l);
    own = k.own{l};
    [nq, nu] = ne_sizes (joint);
    if (nq == 0)
      continue;
    end
    ql = ne_measure (joint, own.s, own.R, 0.3 + 0.2 * (1:nq)');
    [~, ~, E] = ne_freedom (joint, ql, zeros (nu, 1));
    ul = E \ own.rate;
    q = [q; ql];
    u = [u; ul];
    if (nargin > 2)
      [~, ~, ~, bias] = ne_freedom (joint, ql, ul);
      ud = [ud; E \ (own.six * a - own.rest - bias)];
    end
  end
end
