## Digital controllers in compiled runs: against exact difference equations (matrix exponentials
## between the instants, the controllers written anew here), with converters, delays, several
## periods; order of instants, continuation, reproducibility, speed.

function test_sampled ()
  single_step ();
  first_sample ();
  told ();
  drive ();
  delays ();
  rates ();
  crank ();
  speed ();
end

## CTL itself: one sample of each device, all at once, and the rounding of the converters
function single_step ()
  m = gsmbp_fixture ("sampled_rates");
  k = @(name) find (strcmp (m.inputs, name));
  y = zeros (m.sizes.ny, 1);
  count = 2 * pi / 400;
  reads = m.controllers(1).reads;
  away = [];
  for n = [-3, -2.5, -0.5, -0.4, 0, 0.5, 1.49, 7]
    y(reads) = n * count;
    [v, xk] = m.ctl (1, 0, y, zeros (m.sizes.nxk, 1));
    away(end+1) = v(k ("E.angle")) - count * floor (n + 0.5);
  end
  gsmbp_check ("encoder: count of angles from -3 to 7 counts, halves among them", ...
               away(abs (mod ([-3, -2.5, -0.5, -0.4, 0, 0.5, 1.49, 7], 1) - 0.5) > 1e-6), ...
               1e-15);
  y(reads) = 0.3;
  [v1, xk1] = m.ctl (1, 0, y, zeros (m.sizes.nxk, 1));
  [v2, xk2] = m.ctl (2, 0, y, xk1, v1);
  [v3, xk3] = m.ctl (3, 0, y, xk2, v2);
  [v, xk] = m.ctl (0, 0, y, zeros (m.sizes.nxk, 1));
  gsmbp_check ("CTL: K = 0 is all devices in their order", isequal (v, v3) && isequal (xk, xk3));
  gsmbp_check ("CTL: a device leaves the others alone", ...
               isequal (v1(k ("A.out")), 0) && isequal (xk1(3:end), zeros (8, 1)));
end

## A run that begins between two samples: what is held is told by constants, tables and functions
function told ()
  m = gsmbp_fixture ("sampled_rates");
  u = [0.3; 0.2];
  first = gsmbp_simulate (m, [0.2 0 0 0], [0, 0.013], "input", u);
  whole = gsmbp_simulate (m, [0.2 0 0 0], [0, 0.013, 0.1], "input", u);
  v = first.v(end,:)';
  rows = @(t) repmat (v', numel (t), 1);
  inputs = {"constants", v; "a table", gsmbp_plan("table", [0 5], rows ([0 5]), 0); ...
            "a table of order 1", gsmbp_plan("table", [0 5], rows ([0 5]), 1); ...
            "a table that begins later", gsmbp_plan("table", [1 5], rows ([1 5]), 0); ...
            "a function", @(t, x) v}';
  for one = inputs
    for method = {"dp853", "rk4", "radau"}
      r = gsmbp_simulate (m, first.x(end,:), [0.013, 0.0131, 0.1], "input", one{2}, ...
                          "memory", first.memory, "method", method{1});
      gsmbp_check (sprintf ("what is held is told by %s, %s", one{1}, method{1}), ...
                   [r.v(1:2,:)' - v, whole.v(end,:)' - r.v(end,:)'], 1e-9);
    endfor
  endfor
end

## There is no rate at the first sample, whatever the reference and the derivative's gain; a memory
## that no sample left is an error
function first_sample ()
  m = gsmbp_fixture ("sampled_rates");
  k = @(name) find (strcmp (m.inputs, name));
  for r = [-0.2, 0.1, 0.3]
    s = gsmbp_simulate (m, [0.2 0 0 0], [0, 0.001], "input", [r; r]).samples;
    [a, b] = deal (s.v(1,k ("A.out")), s.v(1,k ("B.out")));
    gsmbp_check (sprintf ("first sample: proportional part alone, reference %g", r), ...
                 [a - 4 * (r - 0.2); b - 6 * (r - 0.1 * a)], 0.05);
  end
  names = vertcat (m.controllers.memory);
  for bad = {"A.count", 7, "A: expected count = 0 \\(no sample yet\\) or 1; found A.I = 0"; ...
             "B.count", -1, "B: expected count = 0"; ...
             "E.count", 0.5, "E: expected count = 0"; ...
             "B.old", 0.3, "B: expected count = 1 where old is given; found .*B.old = 0.3"}'
    memory = zeros (numel (names), 1);
    memory(strcmp (names, bad{1})) = bad{2};
    said = gsmbp_complaint (@() gsmbp_simulate (m, [0 0 0 0], [0, 0.01], "memory", memory));
    gsmbp_check (sprintf ("memory: %s = %g is an error", bad{1:2}), ...
                 ! isempty (regexp (said, ["option memory: " bad{3}])));
  end
end

## A wheel of 10 kg m^2 (the drive of the Modelica library's clocked examples: PI of 110 N m s/rad,
## 0.1 s): w+ = w + T*u/J, exact
function drive ()
  m = gsmbp_fixture ("sampled_drive");
  plan = gsmbp_plan ("quintic", [0, 1], [0, 1]);
  told = gsmbp_inverse (m, plan, 0:0.25:1);
  static = gsmbp_inverse (m, plan, 0:0.25:1, "quasistatic", true);
  gsmbp_check ("a drive that is quasi-static already: its command", ...
               columns (told.v) == m.sizes.nv && isequaln (told.v, static.v));
  T = 0.1;
  n = 40;
  p = m.par;
  [w, I] = deal (zeros (1, n + 1));
  for i = 1:n
    e = 1 - w(i);
    u(i) = p.kp * e + I(i);
    w(i+1) = w(i) + T * u(i) / p.J;
    I(i+1) = I(i) + p.ki * T * e;
  end
  t = (0:n) * T;
  for method = {"dp853", "rk4"}
    r = gsmbp_simulate (m, [0 0], t, "input", 1, "method", method{1});
    gsmbp_check (["drive, " method{1} ...
                    ": speed at the samples against the exact difference equation"], ...
                 r.x(:,2) - w', 1e-12);
    gsmbp_check (["drive, " method{1} ": torque"], r.samples.v(:,end) - u', 1e-9);
    gsmbp_check (["drive, " method{1} ": memory"], r.samples.xk(:,1) - I(2:n+1)', 1e-9);
  end
  drawn_in_steps (m, r);
  gsmbp_check ("drive: instants", ...
               [r.samples.t - t(1:n)'; numel(r.samples.t) - n; r.stats.instants - n], 0);
  gsmbp_check ("drive: outputs are those before the instants", r.y(2:end,1) - u', 1e-9);

  ## other output times, a start between the samples, continuation with memory and held outputs
  q = gsmbp_simulate (m, [0 0], sort ([t, 0.033:0.0777:3.9]), "input", 1);
  gsmbp_check ("drive: samples do not depend on the output times", ...
               [q.samples.t - r.samples.t; q.samples.v(:,end) - r.samples.v(:,end)], 1e-9);
  a = gsmbp_simulate (m, [0 0], [0 1.23], "input", 1);
  b = gsmbp_simulate (m, a.x(end,:), [1.23, t(end)], "input", a.v(end,:), "memory", a.memory);
  gsmbp_check ("drive: two runs, the second from 1.23 s, are one", b.x(end,:) - r.x(end,:), 1e-9);
  gsmbp_check ("drive: the second run's first sample is at 1.3 s", b.samples.t(1) - 1.3, 0);
  b = gsmbp_simulate (m, [0 0], [0 t(end)], "input", 1);
  gsmbp_check ("drive: the same run gives the same bits", ...
               isequal (b.samples, gsmbp_simulate (m, [0 0], [0 t(end)], "input", 1).samples));

  ## the reference as a table with a step at a sample: the sample sees the step
  s = gsmbp_simulate (m, [0 0], [0 0.5 0.6], "input", mkpp ([0 0.5 1], [0 1]));
  gsmbp_check ("drive: a step of the reference at a sample is seen there", ...
               [s.samples.v(5:6,end) - [0; 110]; s.x(3,2) - 1.1], 1e-9);
  s = gsmbp_simulate (m, [0 0], [0 0.5 0.6], "input", @(t, x) double (t >= 0.5), "breaks", 0.5);
  gsmbp_check ("drive: the same by a function", s.samples.v(5:6,end) - [0; 110], 1e-9);

  ## a period that is no decimal fraction, far from t = 0: no accumulation
  m = gsmbp_set (m, "period", 1 / 3000);
  r = gsmbp_simulate (m, [0 0], [1e4, 1e4 + 0.01], "input", 1);
  gsmbp_check ("drive: sample k is at k*period", r.samples.t - (3e7:3e7 + 29)' / 3000, 4e-12);
end

function drawn_in_steps (m, r)
  file = [tempname() ".svg"];
  tidy = onCleanup (@() cellfun (@delete, {file, [file(1:end-3) "csv"]}));
  gsmbp_plot (file, m, r, {m.states{2}, m.inputs{end}});
  paths = regexp (fileread (file), "d='([^']*)'", "tokens");
  corners = cellfun (@(d) numel (regexp (d{1}, "[ML]")), paths);
  n = numel (r.t);
  gsmbp_check ("drive: what is held is drawn in steps, states in lines", ...
               any (corners > 2 * n - 10 & corners < 2 * n + 3) && any (abs (corners - n) < 3));
end

## delays shorter and longer than the period
function delays ()
  m = gsmbp_fixture ("sampled_drive");
  T = 0.1;
  n = 30;
  p = m.par;
  for late = [0.03, 0.1, 0.25]
    whole = floor (late / T + 1e-9);
    part = late - whole * T;
    [w, I] = deal (0);
    u = zeros (1, n + whole + 2);   # u(j + whole + 2): output of sample j, j = 0, 1, ..
    kp = 20;
    ki = 30;
    for i = 1:n
      e = 1 - w(i);
      u(i + whole + 1) = kp * e + I;
      I += ki * T * e;
      w(i+1) = w(i) + (part * u(i) + (T - part) * u(i+1)) / p.J;
    end
    c = gsmbp_set (m, "late", late, "kp", kp, "ki", ki);
    r = gsmbp_simulate (c, [0 0], (0:n) * T, "input", 1);
    gsmbp_check (sprintf ("drive, delay of %g s: speed at the samples", late), r.x(:,2) - w', ...
                 1e-12);
  end
  try
    gsmbp_simulate (gsmbp_set (m, "period", 0), [0 0], [0 1]);
    gsmbp_check ("a period of 0 s is an error", false);
  catch err
    gsmbp_check ("a period of 0 s is an error", ! isempty (strfind (err.message, "period")));
  end
end

## encoder and two quantized controllers at 2, 5 and 3 ms: the exact motion between all instants,
## the devices as their entries say
function rates ()
  m = gsmbp_fixture ("sampled_rates");
  for delay = {[0, 0], [0.7e-3, 4.2e-3]}
    c = gsmbp_set (m, "de", delay{1}(1), "db", delay{1}(2));
    r = gsmbp_simulate (c, [0.2 -0.1 0 0], 0:0.01:1, "input", [0.5; 0.3], "rtol", 1e-12);
    y = by_exponentials (c.par, [0.2; -0.1; 0; 0], 1, [0.5, 0.3]);
    what = sprintf ("three periods, delays of %g and %g ms", 1e3 * delay{1});
    gsmbp_check ([what ": states against matrix exponentials"], r.x(end,:)' - y.x, 1e-10);
    last = r.samples.t < 1 - 1e-9;
    gsmbp_check ([what ": outputs of the controllers at the last instant"], ...
                 r.samples.v(find (last)(end),[4, 6]) - y.out, 1e-12);
    gsmbp_check ([what ": number of instants"], sum (last) - y.instants, 0);
  end
  ## the encoder's counts are counts, the outputs are steps of their converters
  gsmbp_check ("outputs are multiples of the converter's step", ...
               [r.samples.v(:,4) / 0.02, r.samples.v(:,6) / 0.005] ...
                 - round ([r.samples.v(:,4) / 0.02, r.samples.v(:,6) / 0.005]), 1e-9);
end

function y = by_exponentials (p, x, stop, reference)
  A = [0 0 1 0; 0 0 0 1; -3/0.02, 0, -0.05/0.02, 0; 0, -5/0.05, 0, -0.1/0.05];
  B = [0 0; 0 0; 1/0.02, 0; 0, 1/0.05];
  res = 2 * pi / 400;
  [angle, speed, a, b] = deal (0);
  old = count = 0;
  I = d = e0 = n = [0 0];
  ## instants: time, what: 0 an output arrives, then the devices in their order
  list = zeros (0, 2);
  for k = 1:3
    T = [p.te, p.ta, p.tb](k);
    list = [list; (0:ceil (stop / T))' * T, k * ones(ceil (stop / T) + 1, 1)];
    late = [p.de, 0, p.db](k);
    if (late > 0)
      list = [list; (0:ceil (stop / T))' * T + late, -k * ones(ceil (stop / T) + 1, 1)];
    end
  end
  list(:,1) = round (list(:,1) * 1e9) / 1e9;
  list(:,3) = list(:,2) > 0;
  list = sortrows (list, [1, 3, 2]);
  t = 0;
  waiting = cell (1, 3);
  times = [];
  pid = struct ("Kp", {4, 6}, "Ki", {20, 15}, "Kd", {0.2, 0.3}, "Tf", {0.01, 0.02}, "Tt", ...
                {0.2, 0.1}, "umax", {3, 4}, "qm", {0.01, 0.001}, "qu", {0.02, 0.005});
  for i = 1:rows (list)
    if (list(i,1) >= stop)
      break;
    end
    x = advance (A, B, x, [a; b], list(i,1) - t);
    t = list(i,1);
    times(end+1) = t;
    switch (list(i,2))
      case 1
        now = res * floor (x(1) / res + 0.5);
        given = [now, count * (now - old) / p.te];
        [old, count] = deal (now, 1);
        if (p.de > 0)
          waiting{1}(end+1,:) = given;
        else
          [angle, speed] = deal (given(1), given(2));
        end
      case {2, 3}
        k = list(i,2) - 1;
        c = pid(k);
        T = [p.ta, p.tb](k);
        sees = [angle, x(2) + 0.1 * a](k);
        e = reference(k) - c.qm * floor (sees / c.qm + 0.5);
        d(k) = (c.Tf * d(k) + n(k) * c.Kd * (e - e0(k))) / (c.Tf + T);
        raw = c.Kp * e + I(k) + d(k);
        given = c.qu * floor (max (-c.umax, min (c.umax, raw)) / c.qu + 0.5);
        draw = (c.Ki * c.Tt)^2 / ((c.Ki * c.Tt)^2 + (c.Kp / 100)^2);
        I(k) += c.Ki * T * e + draw * T / c.Tt * (given - raw);
        e0(k) = e;
        n(k) = 1;
        if (k == 1)
          a = given;
        elseif (p.db > 0)
          waiting{3}(end+1) = given;
        else
          b = given;
        end
      case -1
        [angle, speed] = deal (waiting{1}(1,1), waiting{1}(1,2));
        waiting{1}(1,:) = [];
      case -3
        b = waiting{3}(1);
        waiting{3}(1) = [];
    end
  end
  y.x = advance (A, B, x, [a; b], stop - t);
  y.out = [a, b];
  y.instants = numel (unique (times));
end

function x = advance (A, B, x, u, h)
  if (h > 0)
    E = expm ([A, B; zeros(2, 6)] * h);
    x = E(1:4,:) * [x; u];
  end
end

## a closed chain: the loop stays closed, the record holds what the devices saw
function crank ()
  m = gsmbp_fixture ("sampled_crank");
  x0 = gsmbp_assemble (m, [0.3; -0.1; 0; 0; 0; 0]);
  reference = mkpp ([0 1], [6, 0.3; 0, 6], 2);   # angle 6*t + 0.3, speed 6
  r = gsmbp_simulate (m, x0, 0:0.001:1, "input", reference);
  gsmbp_check ("slider-crank under a computer: loop stays closed", ...
               [r.stats.drift.phi, r.stats.drift.phidot], 1e-12);
  gsmbp_check ("slider-crank: its angle follows 6*t within 0.05 rad at the end", ...
               r.x(end,1) - 6.3, 0.05);
  seen = r.samples.v(1:1000,strcmp (m.inputs, "E.angle"));
  gsmbp_check ("slider-crank: the encoder is half a count from the angle at most", ...
               (seen - r.x(1:1000,1)) / (2 * pi / 4096), 0.5 + 1e-6);
  away = [];
  k = strcmp (m.inputs, "felt.angle");
  for i = 101:100:901
    ## the torque of the sample before is still there when the devices look
    before = r.samples.v(i-1,:)';
    before(m.controllers(1).outputs) = r.samples.v(i,m.controllers(1).outputs);
    ud = m.acc (r.t(i), r.x(i,:)', before);
    away(end+1) = (r.samples.v(i,k) - ud(3)) / 0.01;
  end
  gsmbp_check ("slider-crank: a sampled acceleration is that before the new torque", away, 0.51);
  printf ("   slider-crank at 1 kHz: %.0f times faster than real time\n", 1 / r.stats.seconds);
end

function speed ()
  m = gsmbp_fixture ("mech_digital");
  r = gsmbp_simulate (m, zeros (5, 1), [0 10], "input", [0.5; 0; 0.2]);
  printf (["   two axes, cascade at 1 kHz and PID at 500 Hz: %.0f times faster than " ...
           "real time\n"], 10 / r.stats.seconds);
  gsmbp_check ("two axes under 1 kHz: at least 10 times faster than real time", ...
               10 / r.stats.seconds >= 10);
  s = gsmbp_simulate (m, zeros (5, 1), [0 10], "input", [0.5; 0; 0.2], "samples", false);
  gsmbp_check ("without a record the run is the same", isequal (s.x, r.x) && isempty (s.samples.t));
end
