## Scenes in which nothing moves: circuits alone, against closed forms, by every function that takes
## a model.

function test_still ()
  m = gsmbp_fixture ("still_rlc");
  gsmbp_check ("no coordinates, no speeds", [m.sizes.nq, m.sizes.nu, m.sizes.nx] - [0 0 4], 0);
  step_by_every_method (m);
  exact_slopes (m);
  by_parameters (m);
  poles_and_rest (m);
  many_runs (m);
  refusals (m);
  plant = gsmbp_fixture ("still_plant");
  motors (plant);
  oil (plant);
end

## the voltage and the current of a series circuit behind a step of v, below critical damping
function x = closed_form (r, l, c, v, t)
  s = r / (2 * l);
  w = sqrt (1 / (l * c) - s ^ 2);
  x = [v / (w * l) * exp(-s * t) .* sin(w * t), ...
       v * (1 - exp (-s * t) .* (cos (w * t) + s / w * sin (w * t)))];
end

function step_by_every_method (m)
  t = linspace (0, 0.2, 21)';
  exact = closed_form (10, 0.1, 1e-3, 5, t);
  for method = {"dp853", "rk4", "radau", "gauss", "cvode", "auto"}
    r = gsmbp_simulate (m, zeros (4, 1), t, "input", [0; 5], "method", method{1}, "rtol", 1e-9, ...
                        "step", 2e-4);
    gsmbp_check (["step of a series circuit by " method{1}], ...
                 (r.x(:,1:2) - exact) ./ max (abs (exact)), 2e-7);
  end
  r = gsmbp_simulate (m, zeros (4, 1), t, "input", [1; 5], "audit", 1);
  gsmbp_check ("energy balance", r.audit.error, 1e-9);
end

function exact_slopes (m)
  [A, B, C, D] = m.jac (0.3, [1; 2; 3; 4], [0.5; 7]);
  circuit = [-100 -10; 1000 0];
  gsmbp_check ("A", A - [circuit zeros(2); 0 10 -50 -10; 0 0 1000 0], 1e-12);
  gsmbp_check ("B", B - [0 10; 0 0; 10*sin(0.3) 0; 0 0], 1e-12);
  gsmbp_check ("C", C - [0 0 0 1; 7 0 0 0], 1e-12);
  gsmbp_check ("D", D - [0 0; 0 1], 1e-12);
end

## the derivatives of the closed form by the resistance, by differences of quadruple width
function by_parameters (m)
  t = linspace (0, 0.1, 6)';
  h = 1e-4;
  exact = (closed_form (10 + h, 0.1, 1e-3, 5, t) - closed_form (10 - h, 0.1, 1e-3, 5, t)) / (2 * h);
  r = gsmbp_simulate (m, zeros (4, 1), t, "input", [0; 5], "sensitivity", {"ra"});
  gsmbp_check ("derivatives by the resistance", (r.dx.ra(:,1:2) - exact) ./ max (abs (exact)), ...
               1e-8);
  f = @(x, v) m.rhs (0.3, x, v);
  x = [1; 2; 3; 4];
  v = [0.5; 7];
  weights = [1; -2; 0.5; 3];
  [lx, lv, lp] = m.adj (0.3, x, v, weights);
  [P, A, B] = m.rhp (0.3, x, v);
  gsmbp_check ("backwards as forwards", ...
               [lx; lv; lp] ./ ([A B P]' * weights + ([A B P]' * weights == 0)) - ...
               ([A B P]' * weights != 0), 1e-13);
end

function poles_and_rest (m)
  r = gsmbp_trim (m, zeros (4, 1), [0; 5]);
  gsmbp_check ("at rest the capacitors are charged", r.x - [0; 5; 0; 5], 1e-10);
  sys = gsmbp_linear (m, 0, r.x, r.v);
  exact = [-50 + [1; -1]*1i*sqrt(1e4 - 2500); -25 + [1; -1]*1i*sqrt(1e4 - 625)];
  gsmbp_check ("poles of series circuits", min (abs (pole (sys) - exact.')), 1e-10);
  modes = gsmbp_modes (m, r.x, "input", r.v);
  gsmbp_check ("frequency and damping", ...
               [modes.frequency - 100, sort(modes.damping) - [0.25; 0.5]], 1e-10);
  gsmbp_check ("shapes: the first circuit is still in the second's mode", ...
               [size(modes.shapes) - [4 2], norm(modes.shapes(1:2,1)), ...
                max(abs (modes.shapes)) - 1], 1e-12);
end

## an ensemble is its single runs
function many_runs (m)
  t = [0 0.05 0.1];
  e = gsmbp_ensemble (m, zeros (4, 1), t, "parameters", struct ("ra", [5; 10; 15]), ...
                      "input", [0; 5]);
  for k = 1:3
    exact = closed_form (5 * k, 0.1, 1e-3, 5, t');
    gsmbp_check ("run of an ensemble", (e.x(:,1:2,k) - exact) ./ max (abs (exact)), 1e-8);
  end
end

function refusals (m)
  plan = gsmbp_plan ("quintic", [0 1], [0 1]);
  run = gsmbp_simulate (m, zeros (4, 1), [0 0.1]);
  file = fullfile (getenv ("GSMBP_TEST_DIR"), "still.gif");
  asked = {@() gsmbp_mck(m, 0, zeros (4, 1)), @() gsmbp_animate(m, run, file), ...
           @() gsmbp_inverse(m, plan, 0), @() gsmbp_excite(m, "speed", 1), ...
           @() gsmbp_reduced(m, 0, [], [], {"A"})};
  for ask = asked
    said = gsmbp_complaint (ask{1});
    gsmbp_check (["what needs coordinates says so: " said], ...
                 ! isempty (strfind (said, "in still_rlc nothing moves")));
  end
end

## a motor by the matrix of its two equations, the same with its rotor locked, heat by that current
function motors (m)
  t = linspace (0, 1, 11)';
  r = gsmbp_simulate (m, zeros (5, 1), t, "input", 12, "rtol", 1e-11);
  A = [-2/0.1, -0.3/0.1; 0.3/0.01, -0.02/0.01];
  rest = -A \ [12/0.1; 0];
  exact = cell2mat (arrayfun (@(t) (rest - expm (A * t) * rest)', t, "UniformOutput", false));
  gsmbp_check ("a motor with a free rotor", r.x(:,1:2) - exact, 1e-8);
  current = @(t) 6 * (1 - exp (-20 * t));
  gsmbp_check ("with its rotor locked", r.x(:,3) - current (t), 1e-8);
  warmer = arrayfun (@(t) quadgk (@(s) 2 * current (s) .^ 2 .* exp (-(t - s) / 20) / 10, 0, t, ...
                                  "AbsTol", 1e-12, "RelTol", 1e-12), t);
  gsmbp_check ("its winding gets warm", r.of.("W.warmer") - warmer, 1e-8);
end

## the time to each pressure by quadrature, up to the switch and from there on
function oil (m)
  out = @(p) 4e-8 * p ./ (p .^ 2 + 1e8) .^ 0.25;
  t = [linspace(0, 0.02, 6), linspace(0.024, 0.05, 6)];
  for method = {"dp853", "radau", "cvode"}
    r = gsmbp_simulate (m, zeros (5, 1), t, "method", method{1}, "rtol", 1e-10, "atol", ...
                        [1e-10 1e-10 1e-10 1e-10 1e-4]);
    p = r.of.("O.p");
    took = @(from, to, pumped) quadgk (@(p) 1e-3 / 1.4e9 ./ (pumped - out (p)), from, to, ...
                                       "RelTol", 1e-12, "AbsTol", 1e-14);
    error = [arrayfun(@(k) took (0, p(k), 1e-4) - t(k), 2:6), ...
             arrayfun(@(k) took (p(6), p(k), 0) - (t(k) - 0.02), 7:12)];
    gsmbp_check (["oil that is pumped up to a time by " method{1}], error, 1e-9);
  end
end
