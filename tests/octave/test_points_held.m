## Constraints, forces and devices that read points: rows of the constraints against the Jacobians
## of the points, the force against its projection, the voltage against the places.

function test_points_held ()
  m = gsmbp_fixture ("points_held");
  randn ("seed", 7);
  worst = zeros (1, 4);
  for i = 1:5
    q = randn (m.sizes.nq, 1);
    q(m.orientation) /= norm (q(m.orientation));
    u = randn (m.sizes.nu, 1);
    worst = max (worst, rows_of (m, 0.3*i, q, u));
  end
  names = {"phi", "Jacobian and its time rate", "gamma", ...
           "rates of all rows by differences"};
  for k = 1:4
    gsmbp_check (["constraints on points: " names{k}], worst(k), [1e-12, 1e-12, 1e-12, 1e-8](k));
  end
  reads (m, q, u);
end

function worst = rows_of (m, t, q, u)
  p = @(name, varargin) gsmbp_point (m, name, t, q, u, varargin{:});
  [tip, post, mid, tool, moved] = deal (p ("tip"), p ("post"), p ("mid"), p ("tool"), ...
                                        p ("mid", "frame", "tool"));
  [phi, phit, H, gam] = m.con (t, q, u);
  row = @(name) find (strncmp (m.multipliers, name, numel (name)));
  d = tip.position - post.position;
  e = d / norm (d);
  worst = zeros (1, 4);
  ## a place
  k = row ("line");
  worst(1) = abs (phi(k) - tip.position(3) + 0.2 + 0.1*sin (2*t));
  worst(2) = max ([abs(H(k,:) - tip.jacobian(3,:)), abs(phit(k) + 0.2*cos (2*t))]);
  worst(3) = abs (gam(k) + tip.jacobian_rate(3) + 0.4*sin (2*t));
  ## a distance: d'd = l^2 gives e'd'' = -(v'v - (e'v)^2)/l
  k = row ("rod");
  worst(1) = max (worst(1), abs (phi(k) - norm (d) + 1.5));
  worst(2) = max ([worst(2), abs(H(k,:) - e'*tip.jacobian(1:3,:))]);
  v = tip.velocity;
  worst(3) = max (worst(3), abs (gam(k) + e'*tip.jacobian_rate(1:3) ...
                                 + (v'*v - (e'*v)^2) / norm (d)) / (1 + v'*v / norm (d)));
  ## an angle
  k = row ("bend");
  [x, y] = deal (tip.position - mid.position, post.position - mid.position);
  worst(1) = max (worst(1), abs (phi(k) - acos (x'*y / norm (x) / norm (y)) + 1));
  ## a velocity in axes that turn
  k = row ("blade");
  worst(2) = max ([worst(2), abs(H(k,:) - moved.jacobian(2,:) - 0.1*tool.jacobian(4,:)), ...
                   abs(phit(k) + 0.2)]);
  worst(3) = max (worst(3), abs (gam(k) + moved.jacobian_rate(2) + 0.1*tool.jacobian_rate(4)));
  ## what is left, and the rates of all, by differences along the motion
  rate = @(f) (8*(f(1e-4) - f(-1e-4)) - f(2e-4) + f(-2e-4)) / 12e-4;
  qd = m.kin (t, q, u);
  at = @(h) closed_rows (m, t + h, q + h*qd, u);
  places = phi != 0;
  both = rate (at);
  n = numel (phi);
  worst(4) = max (abs ([(both(1:n) - H*u - phit)(places); both(n+1:end) + gam])) / (1 + norm (gam));
end

function r = closed_rows (m, t, q, u)
  q(m.orientation) /= norm (q(m.orientation));
  [phi, phit, H] = m.con (t, q, u);
  r = [phi; H*u + phit];
end

## force and voltage
function reads (m, q, u)
  p = @(name, varargin) gsmbp_point (m, name, 0, q, u, varargin{:});
  [tip, mid, post] = deal (p ("tip"), p ("mid"), p ("post"));
  axes_ = gsmbp_point (m, "mid", 0, q).rotation;   # those of link c
  F = [-3*tip.position(2); 0; 2*axes_(:,1)'*tip.velocity];
  free = gsmbp_fixture ("points_free");
  gsmbp_check ("force that reads points", ...
               max (abs (free.bia (0, q, u) - m.bia (0, q, u) - mid.jacobian(1:3,:)'*F)), 1e-12);
  [x, y] = deal (tip.position - mid.position, post.position - mid.position);
  v = 5*norm (tip.position - post.position) + acos (x'*y / norm (x) / norm (y));
  x0 = [q; u; 0];
  L = m.par.motor_L;
  given = m.rhs (0, x0)(end);
  rest = free.rhs (0, x0, 0)(end);
  gsmbp_check ("device that reads points", abs (given - rest - v/L) / abs (v/L), 1e-12);
end
