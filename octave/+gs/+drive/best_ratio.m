## f = gs.drive.best_ratio (c, motor)
## Whether a motor can move the load of the cycle C at all, and with which ratios, without losses
## of the gear, friction of the motor and inertia of the gear (Giberti, Cinquemani and Legnani):
## accelerating and load factor, the ratio of least rms torque, those that keep T_cont (NaN: none),
## the largest that omega_max allows, and a sentence.

function f = best_ratio (c, motor)
  mean_of = @(x) trapz (c.t, x) / (c.t(end) - c.t(1));
  [T, a, w] = deal (sqrt (mean_of (c.torque .^ 2)), sqrt (mean_of (c.alpha .^ 2)), ...
                    max (abs (c.omega)));
  cross = mean_of (c.alpha .* c.torque);
  J = motor.Jm;
  f.name = motor.name;
  f.accelerating_factor = motor.T_cont ^ 2 / J;
  f.load_factor = 2 * (a * T + cross);
  f.suits = f.accelerating_factor >= f.load_factor;
  f.ratio = sqrt (T / (J * a));
  [f.ratio_least, f.ratio_largest] = deal (NaN);
  f.ratio_of_speed = motor.omega_max / w;
  ## J^2 a^2 n^4 - (T_cont^2 - 2 J cross) n^2 + T^2 = 0
  half = (motor.T_cont ^ 2 - 2 * J * cross) / 2;
  root = half ^ 2 - (J * a * T) ^ 2;
  if (f.suits && root >= 0)
    larger = half + sqrt (root);
    f.ratio_least = T / sqrt (larger);
    f.ratio_largest = sqrt (larger) / (J * a);
  endif
  f.said = sentence (f, T, a, J, c.unit);
endfunction

function text = sentence (f, T, a, J, unit)
  [load, second] = deal ("N*m", "rad/s^2");
  [one, name] = deal ("", "ratio");
  if (strcmp (unit, "m"))
    [load, second] = deal ("N", "m/s^2");
    [one, name] = deal (" rad/m", "ratio (2*pi/lead)");
  endif
  if (a == 0)
    text = sprintf (["%s: the load never accelerates: the larger the ratio, the smaller the " ...
                     "rms torque; its speed allows n <= %.4g%s"], f.name, f.ratio_of_speed, one);
    return;
  endif
  text = sprintf (["%s: least rms torque at the %s n = sqrt (T_rms/(Jm*alpha_rms)) = sqrt (" ...
                   "%.4g %s/(%.4g kg*m^2 * %.4g %s)) = %.4g%s"], f.name, name, T, load, J, a, ...
                  second, f.ratio, one);
  if (f.suits)
    text = sprintf ("%s; T_cont is kept from n = %.4g to %.4g, omega_max up to n = %.4g", text, ...
                    f.ratio_least, f.ratio_largest, f.ratio_of_speed);
  else
    text = sprintf (["%s; no ratio keeps T_cont: the accelerating factor T_cont^2/Jm = %.4g " ...
                     "W/s is below the load factor 2*(alpha_rms*T_rms + mean (alpha*T)) = %.4g " ...
                     "W/s"], text, f.accelerating_factor, f.load_factor);
  endif
endfunction
