## Choice of a motor and a gear: the case D4, 96 pairs in numbers of 25 digits; the choice by every
## goal against a search by hand; ratios against closed forms (case D2a).

function test_drive ()
  [c, motors, gears, ref] = case_d4 ();
  r = gsmbp_drive (c, "motors", motors, "gears", gears);
  pairs_of_d4 (r, ref);
  best_of_d4 (c, motors, gears, ref);
  ratios_of_d4 (r, ref);
  closed_forms ();
  of_a_run ();
end

## the load cycle of a run is that of the plan that it followed
function of_a_run ()
  m = gsmbp_fixture ("ident_arm");
  plan = gsmbp_plan ("quintic", [0.2 1 0; -0.3 0.5 -0.4], [0 0.7 1.6]);
  t = linspace (0, 1.6, 41);
  r = gsmbp_inverse (m, plan, t);
  a = gsmbp_cycle (m, r, "q2");
  b = gsmbp_cycle (m, gsmbp_simulate (m, r.x(1,:), t, "motion", plan), "q2");
  ## the run follows the plan with a relative tolerance of 1e-10
  gsmbp_check ("a run and its plan", [a.torque - b.torque, a.omega - b.omega], 1e-8);
  gsmbp_check ("the inertia", [a.inertia - m.mas(0, [0; 0])(2,2), a.inertia - b.inertia], 1e-14);
  v = gsmbp_simulate (m, r.x(1,:), t, "input", gsmbp_plan ("table", t, r.v, 1));
  b = gsmbp_cycle (m, v, "q2");
  gsmbp_check ("the torque is the input of the ideal source", b.torque - v.v(:,2), 1e-13);
end

function [c, motors, gears, ref] = case_d4 ()
  here = fileparts (fileparts (mfilename ("fullpath")));
  folder = fullfile (here, "data", "D4_motor_gear_selection");
  motors = gsmbp_catalogue ("motors", fullfile (folder, "motors.csv"));
  gears = gsmbp_catalogue ("gears", fullfile (folder, "gears.csv"));
  c = gsmbp_cycle (dlmread (fullfile (folder, "load_slidercrank.csv"), ",", 1, 0));
  ref = jsondecode (fileread (fullfile (folder, "reference.json")), "makeValidName", false);
  ref = ref.cycles.slidercrank;
end

## every figure of all pairs, and why those fail that do
function pairs_of_d4 (r, ref)
  words = {"torque_peak", "torque_rms", "speed_max", "voltage_max", "temperature_rise", ...
           "gear_torque_peak", "gear_torque_rms", "power_peak", "electric_power_peak", "energy", ...
           "energy_no_recovery", "mass"};
  [worst, same, use] = deal (0, true, 0);
  for p = r.pairs
    one = ref.pairs.(p.name);
    same &= strcmp (one.feasible, {"False", "True"}{1 + p.feasible}) ...
            && strcmp (strjoin (cellstr (one.violated)(:)', ","), strjoin (p.violated, ","));
    for w = words
      worst = max (worst, abs (p.(w{1}) / str2double (one.(w{1})) - 1));
    end
    for w = fieldnames (p.utilization)'
      use = max (use, abs (p.utilization.(w{1}) / str2double (one.utilization.(w{1})) - 1));
    end
  end
  gsmbp_check ("D4: all 96 pairs are there", numel (r.pairs) == 96 && numfields (ref.pairs) == 96);
  gsmbp_check ("D4: feasible or not, and the limits broken, of 96 pairs", same);
  ## the energies are sums that cancel a hundredfold
  gsmbp_check ("D4: 12 figures of 96 pairs", worst, 1e-11);
  gsmbp_check ("D4: use of 8 limits of 96 pairs", use, 1e-13);
end

function best_of_d4 (c, motors, gears, ref)
  for goal = {"power_peak", "mass", "energy", "energy_no_recovery", "torque_rms"}
    r = gsmbp_drive (c, "motors", motors, "gears", gears, "goal", goal{1});
    gsmbp_check (["D4: best by " goal{1}], strcmp (r.best.name, ref.best.(goal{1})));
    gsmbp_check (["D4: the best five by " goal{1}], ...
                 isequal ({r.pairs(r.order(1:5)).name}', ref.top5.(goal{1})));
    found = {r.pairs(r.order).name};
    gsmbp_check (["D4: feasible ones by " goal{1}], isequal (sort (found)', ref.feasible));
    ## a search through all of them finds nothing better
    [least, k] = deal (Inf, 0);
    for i = 1:numel (r.pairs)
      if (isempty (r.pairs(i).violated) && r.pairs(i).(goal{1}) < least)
        [least, k] = deal (r.pairs(i).(goal{1}), i);
      end
    end
    gsmbp_check (["D4: a search through all pairs, by " goal{1}], ...
                 strcmp (r.pairs(k).name, r.best.name));
  end
end

function ratios_of_d4 (r, ref)
  beta = str2double (ref.load_factor_beta);
  gsmbp_check ("D4: load factor", [r.motors.load_factor] / beta - 1, 1e-13);
  e = [];
  for m = r.motors
    factor = str2double (ref.accelerating_factor.(m.name));
    ratio = str2double (ref.optimal_ratio_min_rms_without_gear_loss.(m.name));
    e = [e, m.accelerating_factor / factor - 1, m.ratio / ratio - 1];
  end
  gsmbp_check ("D4: accelerating factors and ratios of 12 motors", e, 1e-13);
end

## a parabola of speed with inertia and a constant load: n^4 = (JL^2 + TL^2*T^4/(12*Theta^2))/Jm^2;
## the trapezoidal rule of 4000 pieces is good for 1e-7
function closed_forms ()
  [Jm, JL, theta, T] = deal (0.0002, 1.8, 1.2, 0.8);
  t = linspace (0, T, 4001)';
  alpha = 6 * theta / T ^ 2 * (1 - 2 * t / T);
  omega = 6 * theta / T ^ 2 * (t - t .^ 2 / T);
  m = gsmbp_catalogue ("motors")(5);
  [m.Jm, m.bm, m.Tc] = deal (Jm, 0, 0);
  for TL = [0, 25]
    c = gsmbp_cycle ([t, omega, alpha, JL * alpha + TL]);
    n = ((JL ^ 2 + TL ^ 2 * T ^ 4 / (12 * theta ^ 2)) / Jm ^ 2) ^ 0.25;
    gsmbp_check (sprintf ("the ratio of least rms torque, load %g N*m: %.4f", TL, n), ...
                 gsmbp_drive (c, "motors", m).motors.ratio / n - 1, 2e-7);
  end
end
