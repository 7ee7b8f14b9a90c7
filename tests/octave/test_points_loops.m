## Points of a closed chain: joints, springs, dampers, forces that stand at points against the same
## scene with links and places; Jacobians, mass, bias and gravity in independent coordinates;
## operational space.

function test_points_loops ()
  m = gsmbp_fixture ("points_bars");
  same_as_places (m);
  [q, u] = closed (m);
  k = find (strcmp (m.speeds, "q1_d"));
  independent (m, q, u, k);
  for name = {"q1", "q2", "q3"}
    against_tree (m, q, u, name{1});
  end
  operational (m, q, u);
  in_axes_of_a_link (m, q, u);
  by_name (m, [q; u; 0]);
  said = gsmbp_complaint (@() gsmbp_reduced (m, 0, q, u, {"q1", "q2"}));
  gsmbp_check (["too many independent coordinates: " said], ! isempty (strfind (said, ...
      "gsmbp_reduced: argument names: expected 1 of the coordinates")));
end

## places of points in results, by name; those on ground stand still and have none
function by_name (m, x)
  r = gsmbp_simulate (m, x, 0:0.01:0.1, "input", 2);
  gsmbp_check ("top.x and so on in a result: what the scene's outputs say", ...
               [r.of.("top.x"), r.of.("top.y"), r.of.("top.z")] ...
               - [r.of.("y.x"), r.of.("y.y"), r.of.("y.z")], 1e-14);
  names = gsmbp_names (m);
  names = {names(strcmp ({names.kind}, "point")).name};
  gsmbp_check (["points by name: " strjoin(names, " ")], ...
               isequal (names(1:3:end), {"c1.x", "r1.x", "c2.x", "top.x"}));
end

## in the axes of a link that carries a point: the place, the Jacobian's rate by differences
function in_axes_of_a_link (m, q, u)
  axes_ = gsmbp_point (m, "top", 0, q).rotation;
  at = @(q) gsmbp_point (m, "r1", 0, q, u, "frame", "coupler");
  p = at (q);
  gsmbp_check ("in the axes of a link: place", p.position ...
               - axes_' * gsmbp_point (m, "r1", 0, q).position, 1e-15);
  h = 1e-6;
  rate = (at (q + h * u).jacobian - at (q - h * u).jacobian) * u / (2 * h);
  gsmbp_check ("in the axes of a link: rate of the Jacobian, by differences", ...
               (p.jacobian_rate - rate) / norm (rate), 1e-7);
  other = m;   # by a point of it; above by a frame that is turned against it
  other.json.points(strcmp (m.points, "c2")).link = "none";
  gsmbp_check ("in the axes of a link: by its point", p.jacobian_rate ...
               - gsmbp_point (other, "r1", 0, q, u, "frame", "coupler").jacobian_rate, 1e-14);
  other.json.points(strcmp (m.points, "top")).link = "none";
  said = gsmbp_complaint (@() gsmbp_point (other, "r1", 0, q, "frame", "coupler"));
  gsmbp_check (["a link without points: " said], ...
               ! isempty (strfind (said, "option frame: link coupler carries no point or frame")));
  said = gsmbp_complaint (@() gsmbp_point (m, "r1", 0, q, "frame", "cuopler"));
  gsmbp_check (["unknown axes: " said], ! isempty (strfind (said, 'unknown frame "cuopler"')));
end

## a closed position and speeds that fulfil the constraints
function [q, u] = closed (m)
  x = gsmbp_assemble (m, m.initial);
  q = x(1:m.sizes.nq);
  [~, phit, H] = m.con (0, q, zeros (m.sizes.nu, 1));
  N = null (H);
  u = N * (3 / N(1));
end

## the scene with places instead of points has the same equations
function same_as_places (m)
  p = gsmbp_fixture ("points_places");
  randn ("seed", 3);
  worst = 0;
  for i = 1:5
    x = randn (m.sizes.nx, 1);
    [q, u] = deal (x(1:3), x(4:6));
    [a, b, c, d] = m.con (0, q, u);
    [e, f, g, h] = p.con (0, q, u);
    worst = max ([worst; abs(m.bia(0, q, u) - p.bia(0, q, u)); abs(a - e); abs(d - h); ...
                  abs(c - g)(:); abs(m.out(0, x, 1) - p.out(0, x, 1))]);
  end
  gsmbp_check ("elements at points: as with links and places", worst, 1e-12);
end

function independent (m, q, u, k)
  [T, c, u0] = m.ind (0, q, u);
  gsmbp_check ("IND: u = T*w + u0", max (abs (T*u(k) + u0 - u)), 1e-12);
  [~, ~, H, gam] = m.con (0, q, u);
  gsmbp_check ("IND: H*T = 0, H*c = gamma", max ([abs(H*T)(:); abs(H*c - gam) / norm(gam)]), 1e-12);
  ud = T * 1.7 + c;
  v = 0.3;
  [M, b, g] = m.red (0, q, u, v);
  tau = T' * m.inv (0, q, u, ud, v);
  gsmbp_check ("RED: efforts on w", abs (M*1.7 + b - tau) / abs (tau), 1e-13);
  gsmbp_check ("RED: gravity", abs (g - T' * m.gra (0, q)), 1e-14);
  [J, dJu] = m.jpt (0, q, u);
  [JI, DI] = m.jpi (0, q, u);
  n = numel (m.points);
  worst = 0;
  for i = 1:n
    block = J(:,3*i-2:3*i);
    worst = max ([worst; abs(JI(:,i) - block*T); abs(DI(:,i) - dJu(:,i) - block*c)]);
  end
  gsmbp_check ("JPI against JPT", worst, 1e-12);
  p = gsmbp_point (m, "top", 0, q, u, ud, "independent", "q1");
  i = find (strcmp (m.points, "top"));
  gsmbp_check ("gsmbp_point in an independent coordinate", ...
               max (abs ([p.jacobian - JI(:,i); p.jacobian_rate - DI(:,i); ...
                          p.jacobian*1.7 + p.jacobian_rate ...
                          - [p.acceleration; p.angular_acceleration]])), 1e-12);
  r = gsmbp_reduced (m, 0, q, u, "q1", v);
  gsmbp_check ("gsmbp_reduced against RED", ...
               abs ([r.M - M; r.bias - b; r.gravity - g]) / norm ([M, b]), 1e-12);
end

## by any of the coordinates: the power of the efforts is that of the tree
function against_tree (m, q, u, name)
  r = gsmbp_reduced (m, 0, q, u, name);
  w = u(r.independent);
  ud = r.T * 0.4 + r.c;
  power = u' * m.inv (0, q, u, ud);
  gsmbp_check (["gsmbp_reduced by " name ": power"], ...
               abs (w * (r.M*0.4 + r.bias) - power) / abs (power), 1e-12);
end

## what acts on the point gives it the acceleration that was asked for
function operational (m, q, u)
  o = gsmbp_operational (m, "top", 0, q, u, "rows", 1, "independent", "q1");
  r = gsmbp_reduced (m, 0, q, u, "q1");
  F = o.inertia * 2.5 + o.bias;
  wd = r.M \ (o.jacobian' * F - r.bias);
  gsmbp_check ("operational space: acceleration of the point", ...
               abs (o.jacobian*wd + o.jacobian_rate - 2.5), 1e-12);
  gsmbp_check ("manipulability of one row", abs (o.manipulability - abs (o.jacobian)), 1e-15);
  said = "";
  try
    gsmbp_operational (m, "top", 0, q, u, "independent", "q1");
  catch problem
    said = problem.message;
  end
  gsmbp_check ("more rows than freedoms are refused", ...
               ! isempty (strfind (said, "cannot be moved")));
end
