## The hydraulic and pneumatic entries in scenes: steps against independent solutions, discharge of
## a vessel, exact Jacobians, energy, inverse and forward, behaviour where the laws have corners.

function test_fluid ()
  hydraulic = gsmbp_fixture ("fluid_hydraulic");
  pneumatic = gsmbp_fixture ("fluid_pneumatic");
  reduced = gsmbp_fixture ("fluid_reduced");
  hydraulic_step (hydraulic);
  pneumatic_step (pneumatic);
  discharge (pneumatic);
  rand ("twister", 4);
  jacobians ("fluid_hydraulic", hydraulic, [1e-3; 1e-3]);
  jacobians ("fluid_pneumatic", pneumatic, 1e-5 * ones (5, 1));
  jacobians ("fluid_reduced", reduced, [1e-3 * ones(5, 1); 1e-5 * ones(5, 1)]);
  nulls (hydraulic, pneumatic);
  beyond_margins (hydraulic);
  back_and_forth ("fluid_hydraulic", hydraulic, "dp853", [0.3 0.45; 0 20]);
  back_and_forth ("fluid_pneumatic", pneumatic, "dp853", [0.03 0.045; 0.045 0.03; 0.11 0.13; 0 20]);
  back_and_forth ("fluid_reduced", reduced, "cvode", ...
                  [0.3 0.45; 0.45 0.3; 0.3 0.45; 0 20; 0 -20; 0.03 0.045; 0.045 0.03; 0.11 0.13; ...
                   0 20]);
end

## where the inverse cannot go on it says which margins are not kept
function beyond_margins (m)
  plan = gsmbp_plan ("septic", [0.3 0.45; 0 20], [0 1]);
  device = m.initial(5:end);
  device(m.internal - 4) = 1e8;
  said = gsmbp_complaint (@() gsmbp_inverse (m, plan, [0, 0.5], "internal", device));
  gsmbp_check ("inverse beyond the supply's pressure names the margin", ...
               ! isempty (regexp (said, ["^gsmbp_inverse: fluid_hydraulic: the internal states " ...
                 "cannot .*; not kept at the first of these times: .*pressure of the rod side"])));
end

## Valves opened at rest. Independent: masses of oil instead of pressures, p = beta*log (m/(rho V))
## in units of rho; Gragg's extrapolation (the model's integrator is Dormand and Prince's).
function hydraulic_step (m)
  t = 0:0.01:0.1;
  u = [3e-4; 2e-4];
  r = gsmbp_simulate (m, m.initial, t, "input", u, "rtol", 1e-12);
  p = m.par;
  beta = p.C_beta;
  root = @(d) d ./ (d .^ 2 + p.C_dp ^ 2) .^ 0.25;
  wide = @(x) (sqrt (x ^ 2 + p.C_eps ^ 2) + x) / 2;
  k = p.C_cd * p.C_g * sqrt (2 / p.C_rho);
  volumes = @(s) [p.C_vd1 + p.C_a1 * s; p.C_vd2 + p.C_a2 * (p.C_h - s)];
  ## x = [place; speed; masses; spool; its speed; turn; its speed; masses]
  function d = motion (t, x)
    q = beta * log (x(3:4) ./ volumes (x(1)));
    flow = k ...
        * [wide(x(5)) * root(p.C_ps - q(1)) - wide(-x(5)) * root(q(1)); ...
           wide(-x(5)) * root(p.C_ps - q(2)) - wide(x(5)) * root(q(2))];
    flow += p.C_ci * [-1; 1] * (q(1) - q(2));
    b = p.M_beta * log (x(9:10) ./ [p.M_v1; p.M_v2]);
    swept = p.M_d * x(8) * [-1; 1];
    through = k ...
        * [wide(u(2)) * root(p.M_ps - b(1)) - wide(-u(2)) * root(b(1)); ...
           wide(-u(2)) * root(p.M_ps - b(2)) - wide(u(2)) * root(b(2))];
    through += p.M_ci * [-1; 1] * (b(1) - b(2));
    torque = p.M_d ...
        * (b(1) - b(2) - p.M_cf * tanh (x(8) / p.M_wc) * sqrt ((b(1) - b(2)) ^ 2 + p.M_dp ^ 2)) ...
        - p.M_bv * x(8);
    d = [x(2); (p.C_a1 * q(1) - p.C_a2 * q(2) - p.C_bv * x(2)) / 100; exp(q / beta) ...
        .* flow; x(6); p.C_om ^ 2 * (u(1) - x(5)) - 2 * p.C_dv * p.C_om * x(6); ...
         x(8); torque / (0.5 + p.M_jr); exp(b / p.M_beta) .* (through + swept)];
  end
  x = m.initial;
  start = [x(1); 0; exp(x(5:6) / beta) .* volumes(x(1)); 0; 0; 0; 0; ...
           exp(x(9:10) / p.M_beta) .* [p.M_v1; p.M_v2]];
  y = gragg (@motion, t, 5e-4, 8, start);
  pressure = zeros (2, numel (t));
  for i = 1:numel (t)
    pressure(:,i) = beta * log (y(3:4,i) ./ volumes (y(1,i)));
  end
  wanted = [y([1 7 2 8],:); pressure; y(5:6,:); p.M_beta * log(y(9:10,:) ./ [p.M_v1; p.M_v2])]';
  gsmbp_check (["hydraulic step: all states, of their range, against the independent " ...
                "solution"], (r.x - wanted) ./ range (wanted), 1e-8);
  audit ("hydraulic step", m, m.initial, linspace (0, 0.1, 101), u);
end

## Valves opened at rest. Independent: masses and energies of the gas instead of pressures and
## temperatures.
function pneumatic_step (m)
  t = 0:0.02:0.1;
  u = [4e-7; -4e-7; 4e-7; 1e-6; 3e-6];
  r = gsmbp_simulate (m, m.initial, t, "input", u, "rtol", 1e-12);
  names = {"PA", "PB", "PC", "PE"};
  for i = 1:4
    part{i} = prefix (m.par, names{i});
  end
  part{3}.da = m.par.growth;
  [A, B, C, E] = part{:};
  ## [mass; energy] of a chamber of volume V with the areas in and out, what it sweeps apart
  function [d, p] = gas (c, z, V, area, work)
    p = (c.k - 1) * z(2) / V;
    T = p * V / (z(1) * c.rg);
    [in, warm_in] = nozzle (c, c.ps, p, c.t0, T);
    [out, warm_out] = nozzle (c, p, c.pa, T, c.t0);
    flow = [wide(area, c.eps) * in; wide(-area, c.eps) * out];
    d = [flow(1) - flow(2); ...
         c.k * c.rg / (c.k - 1) * (warm_in * flow(1) - warm_out * flow(2)) + c.ha * (c.t0 - T) ...
           - p * work];
  end
  ## x = [places; speeds; gas of PA, PB, PC, PE by chambers]
  function d = motion (t, x)
    [s, w] = deal (x(1:4), x(5:8));
    d = zeros (22, 1);
    d(1:4) = w;
    load = [1 2];
    for i = 1:2
      c = part{i};
      [d(4*i+5:4*i+6), p1] = gas (c, x(4*i+5:4*i+6), c.vd1 + c.a1 * s(i), u(2*i-1), c.a1 * w(i));
      [d(4*i+7:4*i+8), p2] = gas (c, x(4*i+7:4*i+8), c.vd2 + c.a2 * (c.h - s(i)), ...
                                  {u(2), -u(3)}{i}, -c.a2 * w(i));
      d(4+i) = (c.a1 * p1 - c.a2 * p2 - c.pa * (c.a1 - c.a2) - c.bv * w(i)) / load(i);
    end
    y = s(3) - C.l0;
    [d(17:18), p] = gas (C, x(17:18), C.v0 + C.ae * y + C.da * y ^ 2 / 2, u(4), ...
                         (C.ae + C.da * y) * w(3));
    d(7) = ((p - C.pa) * (C.ae + C.da * y) - C.kw * y - C.bw * w(3)) / m.par.mt;
    [d(19:20), p1] = gas (E, x(19:20), E.v1, u(5), 0);
    [d(21:22), p2] = gas (E, x(21:22), E.v2, -u(5), 0);
    d(8) = (E.d * (p1 - p2) - E.bv * w(4)) / (0.002 + E.jr);
    ## what the motor carries over: mass and enthalpy of the side it takes from, less its work on
    ## the other side
    side = tanh (w(4) / E.wc);
    mass = [x(19) / E.v1, x(21) / E.v2] * [1 + side; 1 - side] / 2 * E.d * w(4);
    energy = E.d * w(4) * ((p1 + p2) / 2 + (p1 - p2) / 2 * side) / (E.k - 1);
    d(19:22) += [-mass; -energy - p1 * E.d * w(4); mass; energy + p2 * E.d * w(4)];
  end
  x = m.initial;
  start = x(1:8);
  volumes = @(x) [A.vd1 + A.a1 * x(1); A.vd2 + A.a2 * (A.h - x(1)); B.vd1 + B.a1 * x(2); B.vd2 ...
      + B.a2 * (B.h - x(2)); ...
                  C.v0 + C.ae * (x(3) - C.l0) + C.da * (x(3) - C.l0) ^ 2 / 2; E.v1; E.v2];
  V = volumes (start);
  for j = 1:7
    [q, T] = deal (x(7+2*j), x(8+2*j));
    start(7+2*j:8+2*j) = [q * V(j) / (287 * T); q * V(j) / 0.4];
  end
  y = gragg (@motion, t, 2e-3, 8, start);
  wanted = y';
  for i = 1:numel (t)
    V = volumes (y(:,i));
    for j = 1:7
      wanted(i,7+2*j:8+2*j) = [0.4 * y(8+2*j,i) / V(j), 0.4 * y(8+2*j,i) / (y(7+2*j,i) * 287)];
    end
  end
  gsmbp_check (["pneumatic step: all states, of their range, against the independent " ...
                "solution"], (r.x - wanted) ./ range (wanted), 1e-8);
  audit ("pneumatic step", m, m.initial, linspace (0, 0.1, 101), u);
end

## the parameters NAME_x of a model as x
function c = prefix (par, name)
  for [value, key] = par
    if (strncmp (key, [name "_"], numel (name) + 1))
      c.(key(numel (name)+2:end)) = value;
    end
  end
end

function y = wide (x, e)
  y = (sqrt (x ^ 2 + e ^ 2) + x) / 2;
end

## mass flow through a unit of area from A to B, and its temperature: ISO 6358 by its conductance,
## sides picked by the sign of the smoothed drop
function [flow, warm] = nozzle (c, a, b, Ta, Tb)
  drop = hypot (a - b, c.dp);
  up = (a + b + drop) / 2;
  r = 1 - drop / up - c.b;
  r = (r + sqrt (r ^ 2 + c.ec ^ 2 * drop / up)) / 2;
  share = (1 + (a - b) / drop) / 2;
  warm = share * Ta + (1 - share) * Tb;
  flow = (2 * share - 1) * c.cf * c.psi * up / sqrt (c.rg * warm) * sqrt (1 - (r / (1 - c.b)) ^ 2);
end

## A vessel (the bellows under a table that cannot move) blows off from 5 bar to the ambient, choked
## and then not, and is filled again; beside the exact isentropic nozzle. The supply stands at 6
## bar, so that both ways pass the critical ratio.
function discharge (m)
  m = gsmbp_set (m, "mt", 1e12, "PC_ps", 6e5, "PC_eps", 1e-12, "PC_ha", 0, "PC_kw", 0, "PC_bw", ...
                 0, "growth", 0, "PC_cf", 1, "PC_b", (2/2.4)^3.5, "PC_psi", ...
                 sqrt (1.4) * 1.2 ^ -3);
  c = prefix (m.par, "PC");
  at = find (strcmp (m.states, "PC.p"));
  area = 1e-5;
  for way = {"discharge", -1, 5e5, c.pa; "filling", 1, 1.01325e5, c.ps}'
    [name, sense, p0, goal] = way{:};
    x = m.initial;
    x(at) = p0;
    t = linspace (0, 0.6, 121);
    v = zeros (5, 1);
    v(4) = sense * area;
    r = gsmbp_simulate (m, x, t, "input", v, "rtol", 1e-10);
    ## [p; m] by the isentropic nozzle: mass flow with the sonic limit
    function d = exact (t, z)
      T = z(1) * c.v0 / (z(2) * c.rg);
      up = max (z(1), goal);
      Tup = merge (sense < 0, T, c.t0);
      ratio = max (min (z(1), goal) / up, (2 / 2.4) ^ 3.5);
      flow = sign (goal - z(1)) * area * up / sqrt (c.rg * Tup) ...
          * sqrt (2.8 / 0.4 * max (0, ratio ^ (2 / 1.4) - ratio ^ (2.4 / 1.4)));
      d = [1.4 * c.rg * Tup * flow / c.v0; flow];
    end
    y = runge_kutta (@exact, t, 20, [p0; p0 * c.v0 / (c.rg * c.t0)])';
    p = r.x(:,at);
    gsmbp_check (["vessel, " name ": monotone"], sense * diff (p) > -1e-3);
    gsmbp_check (["vessel, " name ": passes the choked limit"], ...
                 (p(1) - goal * {c.b, 1 / c.b}{1 + (sense < 0)}) ...
                   * (p(end) - goal * {c.b, 1 / c.b}{1 + (sense < 0)}) < 0);
    gsmbp_check (["vessel, " name ": ends at the outer pressure"], p(end) / goal - 1, 1e-3);
    gsmbp_check (["vessel, " name ": pressure / 5 bar against the isentropic nozzle"], ...
                 (p - y(:,1)) / 5e5, 0.005);
  end
end

## x at the times t, n steps of the classical method between them
function y = runge_kutta (f, t, n, x)
  y = x;
  h = diff (t(1:2)) / n;
  for i = 1:n*(numel (t) - 1)
    k1 = f (0, x);
    k2 = f (0, x + h/2 * k1);
    k3 = f (0, x + h/2 * k2);
    x += h/6 * (k1 + 2*k2 + 2*k3 + f (0, x + h * k3));
    if (mod (i, n) == 0)
      y(:,end+1) = x;
    end
  end
end

## Exact Jacobians against central differences of fourth order
function jacobians (name, m, size)
  d = m.sizes;
  scale = [m.json.nominal(:); size];
  x = m.initial + scale(1:d.nx) .* (rand (d.nx, 1) - 0.5) ...
      .* [0.01 * ones(d.nq, 1); ones(d.nx - d.nq, 1)] * 0.2;
  v = size .* (rand (d.nv, 1) - 0.5);
  [A, B] = m.jac (0, x, v);
  for k = 1:d.nx + d.nv
    h = 1e-4 * scale(k) * ((1:d.nx + d.nv)' == k);
    f = @(s) m.rhs (0, x + s * h(1:d.nx), v + s * h(d.nx+1:end));
    J(:,k) = (8 * (f (1) - f (-1)) - f (2) + f (-2)) / 12e-4;
  end
  found = [A, B] .* scale';
  gsmbp_check ([name ": exact Jacobians against differences"], ...
               (found - J) ./ max (abs (J), [], 2), 1e-6);
end

## Corners: no pressure drop, valve at its null, equal pressures, end of the stroke. Flow is finite
## there and grows with its cause.
function nulls (hydraulic, pneumatic)
  rises = @(m, x, v, k, by, i) arrayfun (@(s) m.rhs (0, x + s * by * ((1:numel (x))' == k), ...
        v)(i), -1:0.01:1);
  falling = @(y) all (isfinite (y)) && all (diff (y) < 0);
  growing = @(y) all (isfinite (y)) && all (diff (y) > 0);
  x = hydraulic.initial;
  x(7) = 3e-4;
  x(5) = hydraulic.par.C_ps;
  gsmbp_check ("edge: flow falls through the pressure of the supply", ...
               falling (rises (hydraulic, x, [3e-4; 0], 5, 1e6, 5)));
  x(5) = 0;
  gsmbp_check ("edge: and through that of the tank", ...
               falling (rises (hydraulic, x, [3e-4; 0], 5, 1e6, 5)));
  x(5:6) = 5e6;
  x(7) = 0;
  gsmbp_check ("spool: pressure rate grows through the null", ...
               growing (rises (hydraulic, x, [0; 0], 7, 1e-4, 5)));
  x(1) = 0;
  gsmbp_check ("cylinder: finite at the end of its stroke", ...
               isfinite (hydraulic.rhs (0, x, [0; 0])));
  x(9:10) = [12e6; 4e6];
  gsmbp_check ("hydraulic motor: torque falls through standstill", ...
               falling (rises (hydraulic, x, [0; 0], 4, 3, 4)));
  x = pneumatic.initial;
  at = find (strcmp (pneumatic.states, "PE.p1"));
  x(at) = 5e5;
  gsmbp_check ("pneumatic motor: pressure rate falls through standstill", ...
               falling (rises (pneumatic, x, zeros (5, 1), 8, 5, at)));
  x = pneumatic.initial;
  at = find (strcmp (pneumatic.states, "PA.p1"));
  x(at) = pneumatic.par.PA_ps;
  gsmbp_check ("nozzle: flow falls through the pressure of the supply", ...
               falling (rises (pneumatic, x, [1e-5; 0; 0; 0; 0], at, 2e4, at)));
  x(at) = pneumatic.par.PA_pa;
  gsmbp_check ("nozzle: and through that of the ambient", ...
               falling (rises (pneumatic, x, [-1e-5; 0; 0; 0; 0], at, 2e4, at)));
  x(at) = 3e5;
  y = arrayfun (@(u) pneumatic.rhs (0, x, [u; 0; 0; 0; 0])(at), linspace (-1e-6, 1e-6, 201));
  gsmbp_check ("valve: pressure rate grows through the null", growing (y));
end

## The inputs that the inverse gives drive the model along the planned motion, in 1 s from and to
## the columns of ENDS. (Shut valves make the incompressible variants stiff.)
function back_and_forth (name, m, method, ends)
  plan = gsmbp_plan ("septic", ends, [0 1]);
  t = 0:0.1:1;
  r = gsmbp_inverse (m, plan, t);
  gsmbp_check ([name ": the command can be given"], isempty (r.violations));
  for bad = r.violations(:)'
    printf ("   %s at %g s: %g\n", bad.text, bad.time, bad.least);
  end
  back = gsmbp_simulate (m, r.x(1,:)', t, "motion", plan, "method", method, "rtol", 1e-10, ...
                         "atol", 1e-10 * m.json.nominal(:));
  gsmbp_check ([name ": inverse, then forward: coordinates, of their way"], ...
               (back.x(:,1:m.sizes.nq) - r.q) ./ range (r.q), 1e-8);
  gsmbp_check ([name ": inverse, then forward: all states"], ...
               (back.x - r.x) ./ m.json.nominal(:)', 1e-7);
end

## Energy along a run from x on the instants t: Gauss' rule of five points between them; error
## beside the energy that has gone in or was lost. E = kinetic + potential + stored.
function audit (name, m, x, t, v)
  [V, D] = eig (diag ((1:4) ./ sqrt (4 * (1:4) .^ 2 - 1), 1) ...
                  + diag ((1:4) ./ sqrt (4 * (1:4) .^ 2 - 1), -1));
  node = (1 + diag (D)) / 2;
  weight = V(1,:)' .^ 2;
  h = diff (t);
  at = unique ([t, (t(1:end-1) + h .* node)(:)']);
  r = gsmbp_simulate (m, x, at, "input", v, "rtol", 1e-12);
  e = cell2mat (arrayfun (@(i) m.ene (at(i), r.x(i,:)', v)(:), 1:numel (at), "UniformOutput", ...
                          false));
  inner = ! ismember (at, t);
  gone = @(p) sum (h .* (weight' * reshape (p(inner), numel (node), [])));
  E = sum (e(1:3,:));
  passed = gone (abs (e(4,:))) + gone (e(5,:));
  gsmbp_check ([name ": energy audit"], ...
               (E(end) - E(1) - gone (e(4,:)) + gone (e(5,:))) / passed, 1e-8);
  gsmbp_check ([name ": nothing negative is lost"], e(5,:) >= 0);
end
