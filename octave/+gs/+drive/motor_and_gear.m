## p = gs.drive.motor_and_gear (c, motor, gear, amplifier, ratio_limit)
## A motor with a gear (or screw, in the terms of a gear) and an amplifier ([]: none) along the load
## cycle C: figures, what it uses of each limit (1: all of it), the limits that it breaks.

function p = motor_and_gear (c, motor, gear, amplifier, ratio_limit)
  N = gear.ratio;
  speed = N * c.omega;
  J = motor.Jm + gear.J_in;
  T = gs.drive.motor_torque (c, motor, gear);
  i = T / motor.Kt;
  v = motor.R * i + motor.Kb * speed;
  rms = @(x) sqrt (mean_of (c.t, x .^ 2));
  p.name = strjoin ({motor.name, gear.name}, "+");
  [p.motor, p.gear, p.amplifier, p.ratio] = deal (motor.name, gear.name, "", N);
  [p.feasible, p.violated] = deal (true, {});
  [p.torque_peak, p.torque_rms, p.speed_max] = deal (most (T), rms (T), most (speed));
  [p.voltage_max, p.current_peak, p.current_rms] = deal (most (v), most (i), rms (i));
  p.temperature_rise = motor.Rth * motor.R * p.current_rms ^ 2;
  [p.gear_torque_peak, p.gear_torque_rms] = deal (most (c.torque), rms (c.torque));
  p.inertia_ratio = c.inertia / (N ^ 2 * J);
  [p.power_peak, p.electric_power_peak] = deal (most (T .* speed), most (v .* i));
  p.energy = trapz (c.t, v .* i);
  p.energy_no_recovery = trapz (c.t, max (v .* i, 0));
  p.mass = motor.mass + gear.mass;
  p.cost = motor.cost + gear.cost;
  use = {"T_peak", p.torque_peak, motor.T_peak
         "T_cont", p.torque_rms, motor.T_cont
         "omega_max", p.speed_max, motor.omega_max
         "voltage", p.voltage_max, motor.V_max
         "thermal", p.temperature_rise, motor.dT_max
         "gear_peak", p.gear_torque_peak, gear.T_peak
         "gear_cont", p.gear_torque_rms, gear.T_cont
         "gear_speed", p.speed_max, gear.omega_in_max};
  if (isfinite (ratio_limit))
    use(end+1,:) = {"inertia", p.inertia_ratio, ratio_limit};
  endif
  if (isfinite (gear.F_buckling))
    use = [use; {"buckling", p.gear_torque_peak, gear.F_buckling
                 "critical_speed", p.speed_max, gear.omega_critical}];
  endif
  if (! isempty (amplifier))
    p.name = [p.name "+" amplifier.name];
    p.amplifier = amplifier.name;
    p.mass += amplifier.mass;
    p.cost += amplifier.cost;
    use = [use; {"amplifier_voltage", p.voltage_max, amplifier.V_max
                 "current_peak", p.current_peak, amplifier.i_peak
                 "current_cont", p.current_rms, amplifier.i_cont}];
  endif
  [found, limit] = deal ([use{:,2}], [use{:,3}]);
  p.violated = use(! (found <= limit),1)';
  p.feasible = isempty (p.violated);
  p.utilization = cell2struct (num2cell (found ./ limit), use(:,1)', 2);
  p.device = struct ("R", motor.R, "L", motor.L, "K", motor.Kt, "J", J, "B", motor.bm, "tc", ...
                     motor.Tc, "ratio", N, "eta", gear.eta, "Jm", motor.Jm, "J_in", gear.J_in);
endfunction

function y = most (x)
  y = max (abs (x));
endfunction

## mean by the trapezoidal rule
function y = mean_of (t, x)
  y = trapz (t, x) / (t(end) - t(1));
endfunction
