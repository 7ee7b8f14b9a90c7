## list = gs.proof.list_measures (d, m, p)
## What the runs and load cycles P of the machine with the parameters of M use of what is allowed:
## a row of structs for each axis: axis, name, unit, series (a column over the times of all tasks,
## or one number), found (its largest modulus), limit, used. Continuous figures are those of the
## tasks, without the rest that a run has after its task. A run that did not come to its end has an
## infinite tracking error.

function list = list_measures (d, m, p)
  parts = arrayfun (@(j) of_axis (d, m, p, j), 1:numel (d.axes), "UniformOutput", false);
  list = [parts{:}];
endfunction

function list = of_axis (d, m, p, j)
  a = d.axes(j);
  [motor, gear, c] = deal (d.motors(j), d.gears(j), p.cycles(j));
  [K, R, n] = deal (m.par.(a.par.K), m.par.(a.par.R), m.par.(a.par.n));
  along = @(f) vertcat (cellfun (f, p.runs, "UniformOutput", false){:});
  i_rms = rms_of (p.runs, [d.tasks.stop], a.state);
  off = along (@(r) r.error(:,j));
  if (! all (cellfun (@(r) r.ended, p.runs)))
    off(end+1) = Inf;
  endif
  load_rms = sqrt (trapz (c.t, c.torque .^ 2) / (c.t(end) - c.t(1)));
  speed = n * along (@(r) r.x(:,m.sizes.nq + a.k));
  effort = {"N*m", "N"}{1 + strcmp(a.unit, "m")};
  table = {"tracking error", a.unit, off, d.asked.accuracy(j)
           "T_peak", "N*m", K * along(@(r) r.x(:,a.state)), motor.T_peak
           "T_cont", "N*m", K * i_rms, motor.T_cont
           "thermal", "K", motor.Rth * R * i_rms ^ 2, motor.dT_max
           "omega_max", "rad/s", speed, motor.omega_max
           "voltage", "V", along(@(r) r.v(:,a.input)), motor.V_max
           "gear_peak", effort, c.torque, gear.T_peak
           "gear_cont", effort, load_rms, gear.T_cont
           "gear_speed", "rad/s", speed, gear.omega_in_max};
  if (isfinite (gear.F_buckling))
    table = [table; {"buckling", effort, c.torque, gear.F_buckling
                     "critical_speed", "rad/s", speed, gear.omega_critical}];
  endif
  for k = 1:rows (table)
    found = max (abs (table{k,3}));
    list(k) = struct ("axis", a.coordinate, "name", table{k,1}, "unit", table{k,2}, "found", ...
                      found, "limit", table{k,4}, "used", found / table{k,4}, "series", ...
                      table{k,3});
  endfor
endfunction

## the rms of a state over the tasks, each up to its STOP
function x = rms_of (runs, stop, state)
  [square, time] = deal (0);
  for i = 1:numel (runs)
    r = runs{i};
    k = r.t <= stop(i) + 1e-9 * (stop(i) - r.t(1));
    square += trapz (r.t(k), r.x(k,state) .^ 2);
    time += r.t(find (k, 1, "last")) - r.t(1);
  endfor
  x = sqrt (square / time);
endfunction
