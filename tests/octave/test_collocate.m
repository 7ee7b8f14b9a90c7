## Optimal motions: the emitted functions and their derivatives, closed forms, the minimum
## principle, what the machine does with the plan, refusals.

function test_collocate ()
  derivatives (gsmbp_fixture ("optimal_crank"));
  derivatives (gsmbp_fixture ("optimal_cart"));
  program (gsmbp_fixture ("optimal_crank"));
  block (gsmbp_fixture ("optimal_block"));
  bead (gsmbp_fixture ("optimal_bead"));
  gear (gsmbp_fixture ("optimal_gear"));
  arm (gsmbp_fixture ("optimal_arm"));
  swing_up (gsmbp_fixture ("optimal_cart"));
  costates (gsmbp_fixture ("optimal_block"), gsmbp_fixture ("optimal_cart"));
  crank (gsmbp_fixture ("optimal_crank"));
  closed (gsmbp_fixture ("optimal_crank"));
  ends (gsmbp_fixture ("optimal_block"));
  refused (gsmbp_fixture ("optimal_cart"));
end

## DAE against the other subroutines, DAJ and DAH against differences
function derivatives (m)
  d = m.sizes;
  s = m.json.collocation;
  v = 0.3 * ones (d.nv, 1);
  x = m.initial + 0.1 * (1:d.nx)';
  lam = zeros (0, 1);
  if (d.nlam > 0)
    [ud, lam] = m.acc (0.4, x, v);
    xd = m.rhs (0.4, x, v);
  else
    xd = m.rhs (0.4, x, v);
    ud = xd(d.nq+(1:d.nu));
  end
  F = m.dae (0.4, x, ud, lam, v);
  same = [zeros(s.residuals, 1); xd([1:d.nq, d.nq+d.nu+1:d.nx]); m.out(0.4, x, v)];
  gsmbp_check ([m.name ": no residual at the accelerations of RHS, its rates, the outputs"], ...
               norm (F - same, Inf) < 1e-11 * norm (F, Inf));
  z = [0.4; x; ud; lam; v];
  parts = @(z) mat2cell (z, [1, d.nx, d.nu, d.nlam, d.nv], 1);
  of = @(f, z, varargin) f (parts (z){:}, varargin{:});
  n = numel (z);
  m0 = m;
  names = cellstr (s.parameters)';
  if (isempty (s.parameters))
    names = {};
  end
  at = @(m, p) gsmbp_set (m, [names; num2cell(p(:)')](:){:});
  p = cellfun (@(name) m.par.(name), names)(:);
  G = full (sparse (s.jacobian(:,1), s.jacobian(:,2), of (m.daj, z), numel (F), n + numel (p)));
  expected = slope (@(y) of (moved (m, at, y, n).dae, y(1:n)), [z; p]);
  gsmbp_check ([m.name ": DAJ within 1e-9 of differences"], ...
               norm (G - expected, Inf) < 1e-9 * norm (expected, Inf));
  w = cos (1:numel (F))';
  k = s.hessian;
  gsmbp_check ([m.name ": DAH stands in the lower triangle, each entry once"], ...
               all (k(:,1) >= k(:,2)) && rows (unique (k, "rows")) == rows (k));
  H = full (sparse (k(:,1), k(:,2), of (m.dah, z, w), n + numel (p), n + numel (p)));
  H += tril (H, -1)';
  gradient = @(y) full (sparse (s.jacobian(:,1), s.jacobian(:,2), ...
                                of (moved (m, at, y, n).daj, y(1:n)), numel (F), numel (y)))' * w;
  expected = slope (gradient, [z; p]);
  gsmbp_check ([m.name ": DAH within 1e-8 of differences"], ...
               norm (H - expected, Inf) < 1e-8 * norm (expected, Inf));
end

function m = moved (m, at, y, n)
  if (numel (y) > n)
    m = at (m, y(n+1:end));
  end
end

## central differences of order 4
function J = slope (f, z)
  J = [];
  for k = 1:numel (z)
    e = zeros (size (z));
    e(k) = 1e-3 * max (abs (z(k)), 0.1);
    J(:,k) = (8 * (f (z + e) - f (z - e)) - (f (z + 2*e) - f (z - 2*e))) / (12 * e(k));
  end
end

## the derivatives of the whole program, two phases, both rules, parameters
function program (m)
  worst = [0 0 0];
  for method = [1 0]   # lobatto, radau
    breaks = [1 1 2 2; 0 0.4 0 0.7; 0.4 1 0.7 1];
    p = struct ("t0", 0.1, "goal_time", 0.3);
    p.parameters = struct ("name", {"l1", "m3"});
    p.outputs = struct ("number", 1, "low", -1, "high", 1);
    p.goal = struct ("number", {1, 2}, "weight", {2, 0.5});
    p.own = struct ("linear", (1:m.sizes.nx+m.sizes.nu+m.sizes.nlam+m.sizes.nv)', ...
                    "products", [2 2 0.3; 5 1 -0.7]);
    p.singular = struct ("input", 1, "from", 0, "until", 1, "weight", 40);
    p.final = struct ("x", (1:m.sizes.nx)', "y", 0.3 * ones (numel (m.outputs), 1));
    part = @(varargin) m.module ("program", m.cst, gs.model.parameter_values (m), p, method, ...
                                 breaks, varargin{:});
    [n, rows_] = part (-1);
    z = [0.5 + 0.3 * sin((1:n-2)'); 0.21; 1.1];
    l = cos (1:rows_)';
    J_of = @(z) full_of (@() part (3, z, 1, []), rows_, n);
    J = J_of (z);
    H = full_of (@() part (4, z, 0.7, l), n, n);
    H += tril (H, -1)';
    lagrange = @(z) 0.7 * part (1, z, 1, []) + J_of (z)' * l;
    pairs = {J, slope(@(z) part (2, z, 1, []), z); H, slope(lagrange, z)
             part(1, z, 1, [])', slope(@(z) part (0, z, 1, []), z)};
    for k = 1:3
      worst(k) = max (worst(k), norm (pairs{k,1} - pairs{k,2}, Inf) / norm (pairs{k,2}, Inf));
    end
  end
  gsmbp_check (sprintf ("Jacobian, Hessian, gradient: 1e-8, found %.1g %.1g %.1g", ...
                        worst), all (worst < [1e-9, 1e-8, 1e-9]));
end

function A = full_of (part, n, m)
  [v, places] = part ();
  A = full (sparse (places(:,1), places(:,2), v, n, m));
end

function block (m)
  r = gsmbp_collocate (m, [0 0], [1 0], "goal", {"F^2", 1, "F*x_b_d", 7, "x_b", 3}, "time", 1);
  gsmbp_check (sprintf ("a goal of states and inputs without an output: %.9f", r.goal), ...
               r.solved && abs (r.goal - 13.5 + 1/320) < 1e-9);
  for method = {"radau", "lobatto"}
    r = gsmbp_collocate (m, [0 0], [1 0], "goal", "effort", "time", 1, "method", method{1});
    t = r.t;
    gsmbp_check (["block, " method{1} ": cost 12, u = 6 - 12 t, x = 3 t^2 - 2 t^3"], ...
                 r.solved && abs (r.goal - 12) < 1e-9 && norm (r.v - (6 - 12*t), Inf) < 1e-7 ...
                 && norm (r.x(:,1) - (3*t.^2 - 2*t.^3), Inf) < 1e-9);
  end
  held = gsmbp_collocate (m, [0 0], [1 0], "goal", "effort", "time", [0.1 0.8]).active;
  a = held(strcmp ({held.name}, "time"));   # the goal is 12/T^3
  gsmbp_check ("the largest time holds it back, by 36/T^4", strcmp (a.bound, "largest") ...
               && a.value == 0.8 && abs (a.multiplier * 0.8 ^ 4 / 36 - 1) < 1e-6);
  inverse = gsmbp_inverse (m, r.motion, [0.1; 0.5; 0.83]);
  gsmbp_check ("gsmbp_inverse takes the motion, the inputs are those", ...
               norm (inverse.tau - ppval (r.input, [0.1; 0.5; 0.83])(:)) < 1e-8);
  for method = {"radau", "lobatto"}
    r = gsmbp_collocate (m, [0 0], [1 0], "time", [0.1 5], "inputs", {"F", -2, 2}, "method", ...
                         method{1});
    gsmbp_check (["double integrator, " method{1} ": sqrt (2), polished to 1e-12"], ...
                 r.solved && abs (r.goal - sqrt (2)) < 1e-12 ...
                 && abs (r.switches - sqrt (0.5)) < 1e-12);
  end
  gsmbp_check ("both limits of the input hold it back", ...
               isequal (sort ({r.active.bound}), {"largest", "least"}) ...
               && all (strcmp ({r.active.name}, "F")));
  r = gsmbp_collocate (m, [0 0], [1 0], "time", [0.1 5], "inputs", {"F", -2, 2}, "outputs", ...
                       {"speed", -Inf, 0.5}, "polish", false, "accuracy", 1e-4);
  ## 0.25 s up, 0.25 s down on 1/8 m, the rest at 0.5 m/s
  gsmbp_check ("a bound of an output: 2.25 s", abs (r.goal - 2.25) < 1e-3 ...
               && any (strcmp ({r.active.name}, "speed")));
end

function bead (m)
  r = gsmbp_collocate (m, [0 10 0 0], [10 5 NaN NaN], "time", [0.1 10], "inputs", {"N", -20, 20});
  gsmbp_check (sprintf ("brachistochrone: 1e-9, found %.2g", r.goal/1.80160312245308133 - 1), ...
               abs (r.goal / 1.80160312245308133 - 1) < 1e-9 ...
               && abs (hypot (r.x(end,3), r.x(end,4)) - 9.90285312422637116) < 1e-5);
end

## D2a: closed forms of the ratio and the energy
function gear (m)
  expected = [94.868329805051379960, 2.1540166204986149585
              145.758289033132936500, 3.6194035598466068665
              79.733469737575994726, 2.7053430482139276760];
  without = {{"bm", 0, "bL", 0, "TL", 0}, {"bm", 0, "bL", 0}, {"TL", 0}};
  for k = 1:3
    r = gsmbp_collocate (gsmbp_set (m, without{k}{:}), [0 0], [1.2 0], "goal", "loss", "time", ...
                         0.8, "parameters", {"n", 10, 400}, "accuracy", 1e-8);
    off = abs ([r.parameters.n, r.goal] ./ expected(k,:) - 1);
    gsmbp_check (sprintf ("D2a %d: ratio and energy within 1e-8, found %.2g, %.2g", k, off), ...
                 r.solved && all (off < 1e-8));
  end
end

## three jumps of two inputs; expected: the same instants by Newton on the end of runs with constant
## torques, from the equations as they are printed there
function arm (m)
  r = gsmbp_collocate (m, [0 0.5 0 0], [0.522 0.5 0 0], "time", [0.1 10], "accuracy", 1e-7);
  expected = [0.94314035486444; 1.49113997127477; 2.62754506676178; 2.98227994254955];
  off = [r.switches; r.T] - expected;
  gsmbp_check (sprintf ("two-link arm: 2.98228 s, three jumps, each within 1e-9, found %.2g", ...
                        norm (off, Inf)), r.solved && norm (off, Inf) < 1e-9);
end

## the machine with these inputs comes to the end; the plan's inverse dynamics gives them
function swing_up (m)
  r = gsmbp_collocate (m, [0 0 0 0], [1 pi 0 0], "goal", "effort", "time", 2, "states", ...
                       {"p", -2, 2}, "accuracy", 1e-7);
  s = gsmbp_simulate (m, [0 0 0 0], [0; 2], "input", r.input, "rtol", 1e-10);
  off = norm (s.x(end,:) - [1 pi 0 0], Inf);
  gsmbp_check (sprintf ("cart-pole: cost 58.80767, simulated end within 1e-6, found %.2g", ...
                        off), r.solved && abs (r.goal - 58.80767) < 1e-4 && off < 1e-6);
  slow = gsmbp_collocate (m, [0 0 0 0], [1 pi 0 0], "goal", {"drift", 1, "effort", 0.01}, ...
                          "time", [1 3], "states", {"p", -2, 2}, "accuracy", 1e-5, ...
                          "intervals", 30, "guess", r);
  gsmbp_check ("a goal that depends on time, the duration free", slow.solved ...
               && slow.goal < 0.01 * r.goal + trapz (r.t, r.y(:,2)));
end

## a loop with a motor, half a turn in the least time
function crank (m)
  x0 = m.initial;
  xf = x0;
  xf(1) = pi;
  xf(end) = NaN;
  r = gsmbp_collocate (m, x0, xf, "time", [0.05 5], "inputs", {m.inputs{1}, -24, 24});
  s = gsmbp_simulate (m, x0, [0; r.T], "input", r.input, "rtol", 1e-9);
  off = norm (s.x(end,[1 4]) - [pi 0], Inf);
  gsmbp_check (sprintf ("crank: one jump, simulated end within 1e-4, found %.2g", off), ...
               r.solved && numel (r.switches) == 1 && off < 1e-4);
end

## a loop without a guess: what follows the crank; ends that no motion has
function closed (m)
  asked = {"time", 0.5, "goal", [m.inputs{1} "^2"]};
  x0 = gsmbp_assemble (m, [-1 1.4 0.5 0 0 0 0], "hold", "q1");
  x0([1 4]) = [-1 0];
  xf = [1 NaN NaN 0 NaN NaN NaN];
  r = gsmbp_collocate (m, x0, xf, asked{:});
  s = gsmbp_simulate (m, x0, [0; 0.5], "input", r.input, "rtol", 1e-9);
  q3 = gsmbp_assemble (m, [1 -1.4 0.5 0 0 0 0], "hold", "q1")(3);
  off = norm (s.x(end,[1 3 4]) - [1, q3, 0], Inf);
  gsmbp_check (sprintf ("a crank past its dead centre, simulated end %.2g off", off), ...
               r.solved && off < 1e-4);
  follows = x0;
  follows([2 3 5 6]) = NaN;
  other = gsmbp_collocate (m, follows, [1 -1 0.6 0 9 9 NaN], asked{:});
  gsmbp_check ("what follows may be free at the start, is a guess at the end", ...
               abs (other.goal - r.goal) < 1e-6 * r.goal);
  other = gsmbp_collocate (m, x0, [NaN NaN 0.65 NaN NaN 0 NaN], asked{:});
  gsmbp_check ("the slider is demanded where the crank is free", other.solved ...
               && abs (other.x(end,3) - 0.65) < 1e-9);
  asked(end+1:end+2) = {"iterations", 3};
  text = gsmbp_complaint (@() gsmbp_collocate (m, [-1 1.4 0.5 0 0 0 0], xf, asked{:}));
  gsmbp_check (["a start off the loop: " text], ! isempty (regexp (text, ...
               "x0: expected a state on the constraints, found C\.. = ")));
  text = gsmbp_complaint (@() gsmbp_collocate (m, [NaN, x0(2:7)'], xf, asked{:}));
  gsmbp_check (["a start that nothing determines: " text], ! isempty (strfind (text, ...
               "for those that others follow (with their speeds): q1; found NaN for q1")));
  r = quiet (@() gsmbp_collocate (m, x0, xf, asked{:}, "final", {"q3", 0.1, 0.2}));
  gsmbp_check (["bounds beside the end: " r.ended], ! r.solved && ! isempty (strfind (r.ended, ...
               "found bounds of 0.1 to 0.2 there")));
  r = quiet (@() gsmbp_collocate (m, x0, [NaN NaN 0.8 NaN NaN 0 NaN], asked{:}));
  gsmbp_check (["an end out of reach: " r.ended], ! r.solved && ! isempty (strfind (r.ended, ...
               "at the end: expected q3 at most 0.7")));
end

function r = quiet (f)
  was = warning ("off", "gsmbp:collocation", "local");
  r = f ();
end

## the minimum principle: u = -lambda/2 for a block; H is constant where nothing depends on time,
## and lambda what a start that is moved makes of the goal
function costates (block, cart)
  for method = {"radau", "lobatto"}
    r = gsmbp_collocate (block, [0 0], [1 0], "goal", "effort", "time", 1, "method", method{1});
    gsmbp_check (["block, " method{1} ": costates -24 and -12 + 24 t"], ...
                 norm ([r.costates(:,1) + 24; r.costates(:,2) + 12 - 24*r.t], Inf) < 1e-9);
  end
  asked = {"goal", "effort", "time", 2, "states", {"p", -2, 2}};
  r = gsmbp_collocate (cart, zeros (1, 4), [1 pi 0 0], asked{:});
  at = mod (0:rows (r.t)-1, 3) == 0;   # between intervals
  for k = find (at)
    [rate, ~] = cart.rhs (r.t(k), r.x(k,:)', r.v(k,:)');
    H(k) = r.y(k,strcmp (cart.outputs, "effort")) + r.costates(k,:) * rate;
  end
  H = H(at);
  gsmbp_check (sprintf ("cart: the Hamiltonian is %.5f throughout", H(5)), ...
               max (abs (H - H(5))) < 2e-3 * abs (H(5)));
  for k = 1:2
    moved = gsmbp_collocate (cart, [(2*k-3)*1e-5 0 0 0], [1 pi 0 0], asked{:}, "guess", r);
    goals(k) = moved.goal;
  end
  gsmbp_check ("cart: the costate of the place, by differences", ...
               abs (diff (goals) / 2e-5 - r.costates(1,1)) < 1e-4 * abs (r.costates(1,1)));
end

## the end is free, within a range, or worth something: u = 3 s (1 - t) for a path s in 1 s
function ends (m)
  for method = {"radau", "lobatto"}
    r = gsmbp_collocate (m, [0 0], [NaN NaN], "time", 1, "method", method{1}, "goal", ...
                         {"effort", 1, "final x_b", -3});
    gsmbp_check (["the place at the end in the goal, " method{1} ": -3/4"], ...
                 r.solved && abs (r.goal + 0.75) < 1e-8 ...
                   && norm (r.v - 1.5 * (1 - r.t), Inf) < 1e-6);
    r = gsmbp_collocate (m, [0 0], [NaN NaN], "time", 1, "method", method{1}, "goal", "effort", ...
                         "final", {"x_b", 0.5, 1});
    gsmbp_check (["the place at the end in a range, " method{1} ": 3/4"], ...
                 r.solved && abs (r.goal - 0.75) < 1e-8 && abs (r.x(end,1) - 0.5) < 1e-8);
  end
  r = gsmbp_collocate (m, [0 0], [1 NaN], "time", 1, "goal", {"effort", 1, "final effort", 2});
  gsmbp_check ("an output at the end in the goal", r.solved && abs (r.v(end)) < 1e-6);
end

function refused (m)
  call = @(varargin) gsmbp_collocate (m, varargin{:});
  z = zeros (1, 4);
  wrong = {{z, [1 2]}, "argument xf: expected 4 numbers (p, th, p_d, th_d)"
           {z, z}, "option time: expected the duration"
           {z, z, "time", [2 1]}, "option time: expected the duration, or the least"
           {z, z, "time", 1, "goal", "work"}, "option goal: unknown"
           {z, z, "time", 1, "goal", "final q"}, "option goal: unknown"
           {z, z, "time", 1, "goal", "F^3"}, "of states and inputs NAME^2, NAME*NAME"
           {z, z, "time", 1, "regularize", -1}, "option regularize: expected a finite number >= 0"
           {z, z, "time", 1, "final", {"q", 0, 1}}, "option final: unknown"
           {z, z, "time", 1, "inputs", {"F", 2, 1}}, "inputs: F: expected the least"
           {z, z, "time", 1, "outputs", {"x", 0, 1}}, "option outputs: unknown"
           {z, z, "time", 1, "parameters", {"l", 0, 1}}, "it was derived for none"
           {z, z + 3, "time", 1, "states", {"p", -2, 2}}, "p = 3 is not within its bounds, -2 to 2"
           {z, z, "time", 1, "guess", 3}, "option guess: expected a struct with t, x, v"};
  for k = 1:rows (wrong)
    text = gsmbp_complaint (@() call (wrong{k,1}{:}));
    gsmbp_check (["refused: " text], ! isempty (strfind (text, wrong{k,2})));
  end
  warning ("off", "gsmbp:collocation", "local");
  r = call (z, [1 pi 0 0], "time", 0.05);
  gsmbp_check ("what cannot be is told", ! r.solved && ! isempty (r.ended));
  other = gsmbp_fixture ("case_d1a");
  text = gsmbp_complaint (@() gsmbp_collocate (other, [0 0], [1 0], "time", 1));
  gsmbp_check (["refused: " text], ! isempty (strfind (text, "has not the subroutines DAE")) ...
               && ! isempty (strfind (text, "requests : '[all, collocation]$")));
end
