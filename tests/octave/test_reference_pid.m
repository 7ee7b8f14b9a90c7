## PI controllers of a lag with dead time, tuned to margins and Ms (reference D6b: closed forms and
## exact equations of 28 digits); of machines: a motor's speed under a sampled PI controller with
## delay, by margins of its samples; a gear that gives.

function test_reference_pid ()
  pkg load control
  [~, ref] = gsmbp_case ("D6b_pid_fopdt");
  P = tf (2, [1.5, 1]);
  number = @(name, field) str2double (ref.(name).(field));
  for pm = [30, 60]
    name = sprintf ("PM%d", pm);
    c = gsmbp_pid (P, [], "pi", "pm", pm, "Ti", 1.5, "delay", 0.4);
    found = [c.Kp / number(name, "Kc"), c.margins.gain / number(name, "gain_margin"), ...
             c.margins.crossover / number(name, "crossover"), c.margins.Ms / number(name, "Ms")];
    gsmbp_check (["dead time, " name ": gain, gain margin, crossover, Ms"], found - 1, 1e-13);
  end
  for ms = [1.4, 2]
    name = sprintf ("Ms%g", ms);
    c = gsmbp_pid (P, [], "pi", "ms", ms, "Ti", 1.5, "delay", 0.4);
    found = [c.Kp / number(name, "Kc"), c.margins.gain / number(name, "gain_margin"), ...
             c.margins.phase * 180 / pi / number(name, "phase_margin_deg")];
    gsmbp_check (["dead time, " name ": gain, margins"], found - 1, 1e-13);
    gsmbp_check (["dead time, " name ": where it peaks"], ...
                 c.margins.Ms_at / number (name, "w_peak") - 1, 1e-6);
  end
  c = gsmbp_pid (P, [], "pi", "pm", 50, "gm", 4, "delay", 0.4);
  gsmbp_check ("dead time, both margins: gain and time", ...
               [c.Kp / number("GM4_PM50", "Kc"), c.Ti / number("GM4_PM50", "Ti")] - 1, 1e-12);
  best ();
  motor ();
  refused ();
end

## without Ti: no other time has more integral gain at the same Ms
function best ()
  P = tf (1, [1, 3, 3, 1]);
  c = gsmbp_pid (P, [], "pi", "ms", 1.6);
  more = gsmbp_pid (P, [], "pi", "ms", 1.6, "Ti", 1.1 * c.Ti);
  less = gsmbp_pid (P, [], "pi", "ms", 1.6, "Ti", 0.9 * c.Ti);
  gsmbp_check ("largest Ki under Ms", c.Ki > max (more.Ki, less.Ki));
  gsmbp_check ("its Ms", c.margins.Ms / 1.6 - 1, 1e-12);
end

## the margins of the samples are those of the difference equation: the loop at its gain margin has
## poles on the unit circle
function motor ()
  m = gsmbp_fixture ("case_17a");
  x = [0; 100; 0];
  e = gsmbp_trim (m, x, [], "steady", "theta", "free", "motor.v");
  c = gsmbp_pid (m, e, "pi", "ms", 1.5, "measured", "speed", "drop", "theta", "period", 1e-3, ...
                 "delay", 4e-4, "limits", 24);
  gsmbp_check ("motor: Ms of the sampled loop", c.margins.Ms / 1.5 - 1, 1e-12);
  g = c.margins.gain;
  d = c;
  d.C *= g;
  d.D *= g;
  d.poles = eig (closed (d));
  gsmbp_check ("motor: at the gain margin a pole is on the unit circle", ...
               max (abs (d.poles)) - 1, 1e-9);
  folder = fullfile (getenv ("GSMBP_TEST_DIR"), "fortran_out");
  mc = gsmbp_build ("case_17a", "directory", folder, "controller", c);
  r = gsmbp_simulate (mc, e.x, [0, 0.1]);
  gsmbp_check ("motor: it starts at speed without a bump", r.x(end,2:3) - e.x(2:3)', 1e-10);
  for input = {@(t, x) 100, mkpp([0, 1], 100)}
    r = gsmbp_simulate (mc, e.x, [0, 0.1], "input", input{1});
    gsmbp_check (["motor: nor with a reference as a " class(input{1})], ...
                 r.x(end,2:3) - e.x(2:3)', 1e-10);
  end
  r = gsmbp_simulate (mc, e.x, [0, 0.5], "input", 110);
  gsmbp_check ("motor: it comes to another speed", r.x(end,2) - 110, 1e-3);
  r = gsmbp_simulate (mc, e.x, [0, 1, 2], "input", 500);
  gsmbp_check ("motor: 24 V are not enough for 500 rad/s", r.x(end,2) < 400 && r.v(end,1) == 24);
  r = gsmbp_simulate (mc, e.x, [0, 1, 1.2], "input", mkpp ([0, 1, 2], [500, 110]));
  gsmbp_check ("motor: from the limit it comes back without delay", r.x(end,2) - 110, 1);
end
function A = closed (c)
  [F, H, S] = deal (c.plant.a, c.plant.b, c.plant.c);
  A = [F + H * c.D(:,1) * S, H * c.C; c.B(:,1) * S, c.A];
end

function refused ()
  P = tf (2, [1.5, 1]);
  for row = {{P, [], "pi", "Ti", 1}, "expected one goal", {P, [], "pi", "pm", 200}, "below 180", ...
             {P, [], "p", "pm", 60, "Ti", 2}, "a \"p\" has no Ti", ...
             {tf(1, [1, -1]), [], "p", "gm", 2, "delay", 3}, "with a stable loop", ...
             {ss(-1, [1, 1], 1, 0), [], "p", "pm", 60}, "expected one measurement and one input"}
    if (iscell (row{1}))
      given = row{1};
    else
      said = gsmbp_complaint (@() gsmbp_pid (given{:}));
      gsmbp_check (["refused: " row{1}], ! isempty (strfind (said, row{1})));
    end
  end
end
