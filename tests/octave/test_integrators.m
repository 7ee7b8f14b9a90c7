## Orders of the two integrators measured, step control, time without accumulation, jumps of inputs,
## inputs of every kind.

function test_integrators ()
  m = gsmbp_hand ("motor_pendulum");
  q = gsmbp_hand ("motor_pendulum", "precision", "quad");
  c = gsmbp_hand ("hand_crank");
  orders (m, q);
  tolerance (m, q);
  within_steps (q, m, c);
  jumps (m, q);
  kinds_of_input (m);
  feedback (m);
  drift (c);
  closed_plan (c);
  failures (m);
end

function orders (m, q)
  ## slow electrical pole, so that no step is near the limit of stability
  slow = {"L_a", 0.2};
  m = gsmbp_set (m, slow{:});
  q = gsmbp_set (q, slow{:});
  x0 = [1; 0.5; 0];
  exact = gsmbp_simulate (q, x0, [0, 1], "input", 3, "rtol", 1e-26, "atol", 1e-26).x(2,:);
  h = [0.02, 0.01, 0.005];
  for k = 1:3
    e(k) = norm (gsmbp_simulate (m, x0, [0, 1], "input", 3, "method", "rk4", "step", h(k)).x(2, ...
                     :) - exact);
  end
  gsmbp_check (sprintf ("RK4: order %.2f %.2f, less 4", log2 (e(1:2) ./ e(2:3))), ...
               log2 (e(1:2) ./ e(2:3)) - 4, 0.15);
  told = {"input", 3, "method", "rk4", "step"};
  r = gsmbp_simulate (m, x0, [0, 0.5, 1], told{:}, 0.1, "maxstep", h(3));
  s = gsmbp_simulate (m, x0, [0, 0.5, 1], told{:}, h(3), "maxstep", 0.1);
  gsmbp_check ("RK4: no step beyond maxstep", isequal (r.x, s.x) && r.stats.accepted == 200 ...
                                              && r.stats.largest_step <= h(3) * (1 + 1e-12));
  ## steps of Dormand-Prince held fixed by maxstep; in quad the order shows over the whole range
  h = [0.25, 0.125, 0.0625];
  for k = 1:3
    r = gsmbp_simulate (q, x0, 0:h(k)/2:1, "input", 3, "rtol", 0.99, "atol", 1, "maxstep", h(k), ...
                        "step", h(k));
    e(k) = norm (r.x(end,:) - exact);
  end
  gsmbp_check (sprintf ("DOP853: order %.2f %.2f, less 8", log2 (e(1:2) ./ e(2:3))), ...
               log2 (e(1:2) ./ e(2:3)) - 8, 1);
  gsmbp_check ("DOP853: twelve calls a step, three more where outputs lie within it", ...
               r.stats.calls - 15 * r.stats.accepted - 1, 1);
  r = gsmbp_simulate (q, x0, [0, 1], "input", 3, "rtol", 0.99, "atol", 1, "maxstep", h(3), ...
                      "step", h(3));
  gsmbp_check ("DOP853: twelve calls a step without", r.stats.calls - 12 * r.stats.accepted - 1, 1);
end

function tolerance (m, q)
  m = gsmbp_set (m, "L_a", 0.2);
  q = gsmbp_set (q, "L_a", 0.2);
  x0 = [2; 0; 0];
  exact = gsmbp_simulate (q, x0, [0, 2], "rtol", 1e-26, "atol", 1e-26).x(2,:);
  tols = 10 .^ -(4:2:12);
  for k = 1:numel (tols)
    r = gsmbp_simulate (m, x0, [0, 2], "rtol", tols(k));
    e(k) = norm (r.x(2,:) - exact) / tols(k);
    calls(k) = r.stats.calls;
  end
  gsmbp_check (sprintf ("DOP853: error over tolerance, 1e-4 to 1e-12 (calls %s)", ...
                        num2str (calls)), e, 100);
  gsmbp_check ("DOP853: from 1e-4 to 1e-12 the error falls by six decades or more", ...
               e(end) * tols(end) < 1e-6 * e(1) * tols(1));
  gsmbp_check ("DOP853: double at 1e-14 against quad", ...
               gsmbp_simulate (m, x0, [0, 2], "rtol", 1e-14).x(2,:) - exact, 2e-14);
  ## output times are met exactly and do not steer the result
  a = gsmbp_simulate (m, x0, [0, 2], "rtol", 1e-13).x(2,:);
  b = gsmbp_simulate (m, x0, 0:0.01:2, "rtol", 1e-13).x(end,:);
  ## both within a few tens of the tolerance of the truth
  gsmbp_check ("DOP853: 200 output times or one", a - b, 1e-11);
  ## time is t0 + k*h: a run of 1e5 steps of 0.1 s ends at 1e4 exactly, not at 10000.0000000188
  r = gsmbp_simulate (m, x0, [0, 10], "method", "rk4", "step", 1e-4);
  gsmbp_check ("RK4: 1e5 steps, time reached less 10 s", r.stats.reached - 10, 0);
  gsmbp_check ("RK4: 1e5 steps taken", r.stats.accepted - 1e5, 0);
end

## outputs within steps: order 7 of the polynomial, on the constraints, as accurate as ends
function within_steps (q, m, c)
  q = gsmbp_set (q, "L_a", 0.2);
  x0 = [1; 0.5; 0];
  times = 0:0.01:1;
  exact = gsmbp_simulate (q, x0, times, "rtol", 1e-26, "atol", 1e-26).x;
  h = [0.25, 0.125, 0.0625];
  for k = 1:3
    r = gsmbp_simulate (q, x0, times, "rtol", 0.99, "atol", 1, "maxstep", h(k), "step", h(k));
    e(k) = max (max (abs (r.x - exact)));
  end
  gsmbp_check (sprintf ("rows within steps: order %.2f %.2f, less 8", log2 (e(1:2) ./ e(2:3))), ...
               log2 (e(1:2) ./ e(2:3)) - 8, 1);
  start = gsmbp_assemble (c, [0.3 -0.1 0.7 12 0 0]);
  nq = c.sizes.nq;
  for way = {"projection", "partitioning"}
    two = gsmbp_simulate (c, start, [0, 1], "loops", way{1});
    r = gsmbp_simulate (c, start, linspace (0, 1, 301), "loops", way{1});
    gap = arrayfun (@(k) max (abs (c.con (r.t(k), r.x(k,1:nq)', r.x(k,nq+1:end)'))), 1:301);
    gsmbp_check ([way{1} ": rows within steps are on the constraints"], gap, 1e-13);
    more = r.stats.accepted / two.stats.accepted;
    gsmbp_check (sprintf ("%s: 300 rows take few steps more, %.2f of them", way{1}, more), ...
                 more < 1.6);
    truth = gsmbp_simulate (c, start, linspace (0, 1, 301), "loops", way{1}, "rtol", 1e-13);
    gsmbp_check ([way{1} ": rows are as accurate as ends"], r.x - truth.x, 3e-8);
  end
  ## a row that is the time of a break but for rounding, one behind it
  wave = gsmbp_plan ("table", [0, 0.3, 1], [5; -5; -5], 0);
  r = gsmbp_simulate (m, x0, [0, 0.3, 0.3 + 1e-15, 1], "input", wave);
  gsmbp_check ("the inputs at a break from the left, behind it from the right", ...
               r.v' - [5, 5, -5, -5], 0);
end

## a square wave: only stopping at the jumps keeps the order
function jumps (m, q)
  wave = gsmbp_plan ("table", [0, 0.131, 0.377, 0.7, 1], [5; -5; 5; 0; 0], 0);
  x0 = [0.2; 0; 0];
  exact = gsmbp_simulate (q, x0, [0, 1], "input", wave, "rtol", 1e-24, "atol", 1e-24).x(2,:);
  for k = 1:2
    e(k) = norm (gsmbp_simulate (m, x0, [0, 1], "input", wave, "method", "rk4", "step", ...
                                 2e-3 / 2^k).x(2,:) - exact);
  end
  gsmbp_check (sprintf ("RK4 with jumps of the input: order %.2f, less 4", log2 (e(1) / e(2))), ...
               log2 (e(1) / e(2)) - 4, 0.3);
  by_functions (m, x0, wave);
  r = gsmbp_simulate (m, x0, [0, 0.131, 1], "input", wave, "rtol", 1e-12);
  gsmbp_check ("DOP853 with jumps of the input", r.x(3,:) - exact, 1e-11);
  gsmbp_check ("inputs are recorded from the left at a jump", r.v' - [5, 5, 0], 0);
end

## the same by functions that have in the jump itself the value before it or behind it, where
## "breaks" tells the jumps: those in the run, and those where it begins and ends
function by_functions (m, x0, wave)
  at = wave.breaks(2:4);
  behind = @(t, x) 5 - 10 * (t >= at(1)) + 10 * (t >= at(2)) - 5 * (t >= at(3));
  before = @(t, x) 5 - 10 * (t > at(1)) + 10 * (t > at(2)) - 5 * (t > at(3));
  run = @(v, x, t, varargin) gsmbp_simulate (m, x, t, "input", v, varargin{:});
  for w = {{"method", "rk4", "step", 1e-3}, {"rtol", 1e-12}, {"method", "radau"}}
    told = [w{1}, {"breaks", at}];
    r = run (wave, x0, [0, at, 1], told{:});
    for f = {behind, before}
      s = run (f{1}, x0, [0, at, 1], told{:});
      gsmbp_check ([w{1}{2} ": a function that jumps is a table that jumps"], s.x - r.x, 1e-9);
      gsmbp_check ("... and is recorded from the left there", s.v - r.v, 0);
      s = run (f{1}, x0, [0, at(1)], told{:});
      s = run (f{1}, s.x(2,:), at(1:2), told{:});
      gsmbp_check ("... in runs from jump to jump too", s.x(2,:) - r.x(3,:), 1e-9);
    end
  end
end

function kinds_of_input (m)
  x0 = [0.2; 0; 0];
  t = 0:0.25:1;
  v = @(t) 3 * sin (5 * t);
  callback = gsmbp_simulate (m, x0, t, "input", @(t, x) v (t), "rtol", 1e-12);
  s = (0:0.001:1)';
  table = gsmbp_simulate (m, x0, t, "input", gsmbp_plan ("table", s, v (s), 3), "rtol", 1e-12);
  ## the spline is off by 5/384*h^4*v'''' = 2e-11 V
  gsmbp_check ("input by callback and by a cubic table", callback.x - table.x, 1e-9);
  gsmbp_check ("input is recorded", callback.v - v (t'), 1e-15);
  linear = gsmbp_simulate (m, x0, t, "input", gsmbp_plan ("table", s, v (s), 1), "rtol", 1e-12);
  gsmbp_check ("input by a linear table: off by h^2/8*v''", ...
               max (abs (linear.x(:,1) - callback.x(:,1))) < 2e-5);
  constant = gsmbp_simulate (m, x0, t, "input", 2);
  same = gsmbp_simulate (m, x0, t, "input", @(t, x) 2);
  gsmbp_check ("constant input", constant.x - same.x, 0);
  ## compiled subroutine of the user
  source = user_input ();
  own = gsmbp_hand ("motor_pendulum", "input", source);
  gsmbp_check ("input by a Fortran subroutine", ...
               gsmbp_simulate (own, x0, t, "input", "user", "rtol", 1e-12).x - callback.x, ...
               1e-12);
  delete (source);
  failed = false;
  try
    gsmbp_simulate (m, x0, t, "input", @(t, x) error ("no input here"));
  catch err
    failed = ! isempty (strfind (err.message, "no input here"));
  end
  gsmbp_check ("an error in the callback arrives", failed);
  ## planned motion through the inverse model
  plan = gsmbp_plan ("septic", [0.2, 1.5], [0, 1]);
  start = gsmbp_inverse (m, plan, 0).x';
  r = gsmbp_simulate (m, start, t, "motion", plan, "rtol", 1e-12);
  gsmbp_check ("open loop along a planned motion, rad", r.x(:,1)' - gsmbp_evaluate (plan, t), ...
               1e-11);
end

## lqr about a planned motion: an error at the start dies out
function feedback (m)
  plan = gsmbp_plan ("septic", [0, 2], [0, 1]);
  t = 0:0.01:1;
  nominal = gsmbp_inverse (m, plan, t);
  K = zeros (1, 3);
  K(1:2) = [20, 4];
  start = nominal.x(1,:)' + [0.1; 0; 0];
  options = {"motion", plan, "rtol", 1e-10};
  open = gsmbp_simulate (m, start, t, options{:});
  closed = gsmbp_simulate (m, start, t, options{:}, "gain", K, "reference", ...
                           gsmbp_plan ("table", t, nominal.x, 3));
  gsmbp_check (sprintf (["state feedback along a trajectory: 0.1 rad becomes %.4f, in open " ...
                         "loop %.4f"], ...
                        closed.x(end,1) - 2, open.x(end,1) - 2),
               abs (closed.x(end,1) - 2) < 0.2 * abs (open.x(end,1) - 2));
  ## the same gain from a table; and the formula itself at the record
  tabled = gsmbp_simulate (m, start, t, options{:}, "gain", ...
                           mkpp ([0, 0.4, 1], repmat (K, 2, 1)'(:), 3), "reference", ...
                           gsmbp_plan ("table", t, nominal.x, 3));
  gsmbp_check ("gain constant and tabulated", tabled.x - closed.x, 1e-8);
  gsmbp_check ("v = v0 - K*(x - x0)", closed.v - nominal.v + (closed.x - nominal.x) * K', 1e-9);
end

function drift (c)
  x0 = gsmbp_assemble (c, [0.3, -0.1, 0.7, 12, 0, 0], "hold", "q1");
  for [mode, name] = struct ("free", {{0, false}}, "baumgarte", {{5, false}}, "projection", ...
                             {{0, true}})
    b = gsmbp_set (c, "alpha", mode{1}, "beta", mode{1});
    r = gsmbp_simulate (b, x0, [0, 50], "method", "rk4", "step", 1e-3, "projection", mode{2});
    d.(name) = r.stats.drift;
    printf (["drift of the loop, 5e4 steps of 1 ms, %s: |phi| %.1e m, |phidot| %.1e " "m/s\n"], ...
            name, r.stats.drift.phi, r.stats.drift.phidot);
  end
  gsmbp_check ("Baumgarte keeps the loop better than nothing", d.baumgarte.phi < 0.01 * d.free.phi);
  gsmbp_check ("projection keeps the loop closed, m", d.projection.phi, 1e-13);
  gsmbp_check ("projection keeps the speeds in the loop, m/s", d.projection.phidot, 1e-13);
end

function closed_plan (c)
  plan = gsmbp_plan ("septic", [0.3, 9], [0, 1.5]);
  t = 0:0.1:1.5;
  start = gsmbp_inverse (c, plan, 0).x';
  r = gsmbp_simulate (c, start, t, "motion", plan, "rtol", 1e-12);
  gsmbp_check ("closed chain, open loop along a planned motion, rad", ...
               r.x(:,1)' - gsmbp_evaluate (plan, t), 1e-9);
end

function failures (m)
  fast = gsmbp_set (m, "L_a", 1e-5);
  [r, info] = gsmbp_simulate (fast, [1; 0; 0], 0:0.1:1, "input", 2, "method", "rk4", "step", 0.01);
  gsmbp_check ("RK4 beyond its stability is reported", ...
               info == 4 && numel (r.t) < 11 && all (isfinite (r.x(:))));
  [r, info] = gsmbp_simulate (m, [1; 0; 0], [0, 1], "maxsteps", 5);
  gsmbp_check ("the limit of steps is reported", info == 1);
  seen = false;
  try
    gsmbp_simulate (m, [1; 0; 0], [0, 1], "maxsteps", 5);
  catch err
    seen = ! isempty (strfind (err.message, "more steps than option maxsteps allows"));
  end
  gsmbp_check ("... and is an error where it is not taken", seen);
end
