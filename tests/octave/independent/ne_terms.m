## [M, c, G] = ne_terms (M, Q, U): mass matrix, velocity and gravity terms of the tree, tau = M ud +
## c + G, each by inverse dynamics.

function [M, c, G] = ne_terms (m, q, u)
  [~, nu] = ne_sizes (m);
  n = sum (nu);
  for j = 1:numel (m.joint)
    m.joint(j).damping(:) = 0;
    m.joint(j).stiffness(:) = 0;
  end
  m.loop = [];
  m.given = m.spring = [];
  still = zeros (n, 1);
  G = ne_inverse (m, q, still, still);
  m.gravity(:) = 0;
  c = ne_inverse (m, q, u, still);
  M = zeros (n);
  for j = 1:n
    ud = still;
    ud(j) = 1;
    M(:, j) = ne_inverse (m, q, still, ud);
  end
end
