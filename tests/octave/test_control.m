## Controllers on machines: a compiled run with a sampled controller against the difference equation
## of plant and controller, each kind of design; saturation, converters and delay on the non-linear
## machine, and where it fails; the controller alone in Fortran and C; what is refused.

function test_control ()
  pkg load control
  designs ();
  alone ();
  schedule ();
  limits ();
  beside_an_encoder ();
  output_feedback ();
  hinf ();
  stiff_joint ();
  refused ();
end

function [m, e] = cart ()
  persistent model trim
  if (isempty (model))
    model = gsmbp_fixture ("case_d6a");
    trim = gsmbp_trim (model, model.initial, 0, "hold", "x");
  end
  [m, e] = deal (model, trim);
end

function mc = with (name, c)
  folder = fullfile (getenv ("GSMBP_TEST_DIR"), "fortran_out");
  mc = gsmbp_build (name, "directory", folder, "controller", c);
end

## small motions: the machine is linear, and its samples are those of the difference equation
function designs ()
  [m, e] = cart ();
  two = {"position", "angle"};
  poles = {"poles", [-2, -3, -4+1i, -4-1i]};
  all_ = {{"lqg", "measured", two, "delay", 0.004, "integral", "position"}, ...
          {"place", "measured", two, "observer", "full", poles{:}, "track", "position"}, ...
          {"place", "measured", two, "observer", "reduced", "delay", 0.047, poles{:}}};
  for one = all_
    c = gsmbp_control (m, e, one{1}{:}, "period", 0.02);
    mc = with ("case_d6a", c);
    x = 1e-6 * [0.3; 1; 0; 0];
    r = gsmbp_simulate (mc, x, (0:40) * 0.02, "rtol", 1e-13, "input", ...
                        1e-6 * ones (1, numel (c.references)));
    [X, V] = difference (c, x, 1e-6, 41);
    what = sprintf ("%s, delay %g s, observer by %d numbers", c.method, c.delay, numel (c.L));
    gsmbp_check ([what ": states at the samples, of their size"], max (abs (r.x - X)(:)) / 1e-6, ...
                 1e-9);
    if (c.delay == 0)
      gsmbp_check ([what ": what it asks for"], (r.samples.v(:,1) - V(1:40,1)) / 1e-6, 1e-8);
    end
    gsmbp_check ([what ": it is stable"], abs (c.poles) < 1);
    r = gsmbp_simulate (mc, e.x, [0, 1]);
    gsmbp_check ([what ": at the trim nothing moves"], r.x, 0);
  end
end

## plant and controller of c, R all references
function [X, V] = difference (c, x, R, n)
  [F, H, S] = deal (c.plant.a, c.plant.b, c.plant.c);
  x = [x; zeros(rows (F) - numel (x), 1)];
  z = zeros (rows (c.A), 1);
  for k = 1:n
    X(k,:) = x(1:4)';
    d = [S * x; R * ones(numel (c.references), 1)];
    V(k,:) = (c.C * z + c.D * d)';
    z = c.A * z + c.B * d;
    x = F * x + H * V(k,:)';
  end
end

## the same numbers from the controller's own Fortran and C as from the run
function alone ()
  [m, e] = cart ();
  c = gsmbp_control (m, e, "lqg", "measured", {"position", "angle"}, "period", 0.02, ...
                     "integral", "position", "limits", [-0.7, 1.2], "step_in", 1e-4, ...
                     "step_out", 0.01, "name", "upright");
  mc = with ("case_d6a", c);
  r = gsmbp_simulate (mc, [0; 0.06; 0; 0], (0:400) * 0.02, "input", 0.1);
  gsmbp_check ("alone: the run is at both limits", ...
               [min(r.samples.v(:,1)) + 0.7, max(r.samples.v(:,1)) - 1.2], 1e-12);
  gsmbp_check ("... and comes to its reference", r.x(end,1) - 0.1, 0.05);
  [status, u] = compiled (c, r.y(1:end-1,1:2), 0.1);
  gsmbp_check ("alone: Fortran and C compile without a warning and run", status == 0);
  gsmbp_check ("alone: outputs in C and Fortran as in the run [N]", u - r.samples.v(:,1), 1e-12);
end

## what the controller's own C and Fortran give for rows of measurements, a column each
function [status, u] = compiled (c, y, r)
  folder = tempname ();
  files = gsmbp_controller (c, folder);
  guard = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
  f = fopen (fullfile (folder, "main.c"), "w");
  fprintf (f, ["#include <stdio.h>\n#include \"upright.h\"\nvoid upright_ (double *, double *, " ...
               "double *, double *);\nvoid upright_start_ (double *, double *, double *, " ...
               "double *);\nint main (void)\n{\n  double y[9], r[1] = {%g}, z[9], u[1], zf[9], " ...
               "uf[1], p, d;\n  int k = 0;\n  upright_start (z, u);\n" ...
               "  upright_start_ (zf, uf, &p, &d);\n" ...
               "  if (p != UPRIGHT_PERIOD || d != UPRIGHT_DELAY) return 1;\n" ...
               "  while (scanf (\"%%lf\", y + k) == 1) {\n    if (++k < %d) continue;\n" ...
               "    k = 0;\n    upright (y, r, z, u);\n    upright_ (y, r, zf, uf);\n" ...
               "    printf (\"%%.17g %%.17g\\n\", u[0], uf[0]);\n  }\n  return 0;\n}\n"], r, ...
           columns (y));
  fclose (f);
  f = fopen (fullfile (folder, "y.txt"), "w");
  fprintf (f, "%.17g\n", y');
  fclose (f);
  [status, said] = system (sprintf (["cd %s && gfortran -std=legacy -Wall -Werror -c " ...
                                     "upright.f && gcc -std=c99 -Wall -Wextra -Werror -o main " ...
                                     "main.c upright.c upright.o -lgfortran -lm && " ...
                                     "./main <y.txt"], folder));
  u = reshape (sscanf (said, "%f"), 2, [])';
end

## a schedule in Fortran and C against the blended laws written anew
function schedule ()
  laws = cell (1, 3);
  for k = 1:3
    sys = ss ([0, 1; 0, -1], [0; k], [1, 0], 0, "OutputName", "place");
    laws{k} = gsmbp_control (sys, [], "place", "poles", [-2, -3, -4], "integral", "place", ...
                             "period", 0.02, "limits", 3, "name", "upright");
    [laws{k}.u0, laws{k}.y0, laws{k}.r0] = deal (0.1 * k, 0.05 * k, 0.05 * k);
  end
  c = gsmbp_schedule (laws, "place", [0, 0.2, 0.5]);
  y = [-0.3:0.05:0.9, 0.2, 0.5];
  z = zeros (rows (c.A), 1);
  for k = 1:numel (y)
    i = 1 + (y(k) >= 0.2);
    s = min (1, max (0, (y(k) - c.schedule.values(i)) / diff (c.schedule.values(i:i+1))));
    [w, n, G] = deal (0);
    for part = [1 - s, s; i, i + 1]
      l = laws{part(2)};
      e = [y(k) - l.y0; 0.4 - l.r0];
      w += part(1) * (l.u0 + l.C * z + l.D * e);
      n += part(1) * (l.A * z + l.B * e);
      G += part(1) * l.G;
    end
    u(k,1) = max (-3, min (3, w));
    z = n + G * (u(k) - w);
  end
  [status, found] = compiled (c, y', 0.4);
  gsmbp_check ("schedule: it compiles without a warning and runs", status == 0);
  gsmbp_check ("schedule: outputs in C and Fortran as the blended laws", found - u, 1e-12);
  gsmbp_check ("schedule: at the limits too", max (abs (u)) - 3, 0);
end

## the non-linear machine with converters, delay and limits: from how far it comes back
function limits ()
  [m, e] = cart ();
  c = gsmbp_control (m, e, "lqg", "measured", {"position", "angle"}, "Q", [10, 10, 1, 1], "W", ...
                     0.01, "V", 1e-6, "period", 0.01, "delay", 0.004, "limits", 10, "step_in", ...
                     1e-4, "step_out", 0.01);
  mc = with ("case_d6a", c);
  fell = @(angle) max (abs (gsmbp_simulate (mc, [0; angle; 0; 0], 0:0.05:8).x(end-20:end,2))) > 0.1;
  gsmbp_check ("10 N at most: it comes back from 0.2 rad", ! fell (0.2));
  gsmbp_check ("10 N at most: it falls from 0.9 rad", fell (0.9));
end

## the controller sees the angle by an encoder of the scene, a sampled device ahead of it
function beside_an_encoder ()
  m = gsmbp_fixture ("control_encoder");
  [A, B] = deal ([0, 1; 0, 0], [0; 1 / m.par.J]);
  sys = ss (A, B, [1, 0], 0, "InputName", "tau", "OutputName", "angle");
  c = gsmbp_control (sys, [], "place", "poles", [-8, -10], "period", 0.002, "track", "angle");
  mc = with ("control_encoder", c);
  gsmbp_check ("encoder: both devices are in the run", ...
               isequal ({mc.controllers.name}, {"E", "ctl"}) && mc.sizes.nxk == m.sizes.nxk + 2);
  r = gsmbp_simulate (mc, [0.3; 0], 0:0.1:2, "input", 1);
  count = 2 * pi / 1000;
  gsmbp_check ("encoder: it comes to the reference, within a count", ...
               abs (r.x(end,1) - 1) < count && any (r.x(:,1) > 0.6));
end

function output_feedback ()
  A = [0, 1, 0; 0, 0, 1; -6, -11, -6];
  sys = ss (A, [0; 0; 1], eye (3), 0);
  c = gsmbp_control (sys, [], "output");
  k = gsmbp_control (sys, [], "lqr");
  gsmbp_check ("output feedback of all states is the LQR", c.F - k.K, 1e-9);
  ## first-order conditions, with one measurement
  sys = ss (A, [0; 0; 1], [1, 1, 0], 0);
  c = gsmbp_control (sys, [], "output", "Q", [3, 2, 1], "R", 0.1);
  Z = A - [0; 0; 1] * c.F * [1, 1, 0];
  P = lyap (Z', diag ([3, 2, 1]) + 0.1 * c.F ^ 2 * [1; 1; 0] * [1, 1, 0]);
  L = lyap (Z, eye (3));
  D = 0.1 * c.F * [1, 1, 0] * L * [1; 1; 0] - [0, 0, 1] * P * L * [1; 1; 0];
  gsmbp_check ("output feedback: the gradient vanishes", D, 1e-9);
  J = @(F) trace (lyap ((A - [0; 0; 1] * F * [1, 1, 0])', ...
                        diag ([3, 2, 1]) + 0.1 * F ^ 2 * [1; 1; 0] * [1, 1, 0]));
  gsmbp_check ("output feedback: least", J (c.F) < min (J (c.F + 1e-3), J (c.F - 1e-3)));
end

function hinf ()
  sys = ss ([0, 1; -2, -0.3], [0; 1], [1, 0], 0);
  w = {tf([0.5, 1], [1, 0.01]), 0.1, []};
  c = gsmbp_control (sys, [], "hinf", "weights", w);
  K = ss (c.A, -c.B, c.C, -c.D);
  S = feedback (1, sys * K);
  reached = norm ([w{1} * S; w{2} * K * S], Inf);
  gsmbp_check ("H-infinity: the norm that it tells is that of the loop", reached / c.gamma - 1, ...
               0.02);
end

## A motor's gear that gives by 1e5 N m/rad before a load, at 1 kHz: badly scaled.  The gain fulfils
## Riccati's equation (residual in scaled states)
function stiff_joint ()
  [k, J1, J2, d] = deal (1e5, 2e-2, 3, 5);
  A = [0, 0, 1, 0; 0, 0, 0, 1; -k / J1, k / J1, -d / J1, d / J1; k / J2, -k / J2, d / J2, -d / J2];
  B = [0; 0; 1 / J1; 0];
  c = gsmbp_control (ss (A, B, eye (4), 0), [], "lqr", "Q", [0, 100, 0, 1], "R", 1e-4, "period", ...
                     1e-3);
  [F, H] = deal (c.plant.a, c.plant.b);
  Z = F - H * c.K;
  P = dlyap (Z', diag ([0, 100, 0, 1]) + c.K' * 1e-4 * c.K);
  K = (1e-4 + H' * P * H) \ (H' * P * F);
  gsmbp_check ("elastic gear at 1 kHz: the gain is that of its own cost", ...
               (K - c.K) / norm (c.K), 1e-9);
end

function refused ()
  [m, e] = cart ();
  sys = ss ([-1, 0; 0, 1], [1; 0], [1, 1], 0);
  for row = {{m, e, "lqr", "measured", "angel"}, ...
             "unknown name \"angel\", did you mean \"angle\"", ...
             {m, e, "lqr", "delay", 0.1}, "expected a period too", ...
             {m, e, "lqr", "Q", [1 2]}, "option Q: expected a number, 4 numbers or 4 x 4", ...
             {m, e, "lqr", "Q", [1 2 3 -1]}, "not negative, found eigenvalues down to -1", ...
             {m, e, "lqr", "Q", eye(4) + [0 0 2 0]' * [1 0 0 0]}, ...
             "expected a symmetric matrix, found 2 at (3, 1), 0 at (1, 3)", ...
             {m, e, "lqr", "R", 0}, "expected a matrix that is positive", ...
             {m, e, "place", "poles", [-1 -2 1 -3]}, "negative real parts, found 1", ...
             {m, e, "place", "poles", [-1 -2]}, "expected 4 poles", ...
             {m, e, "place", "poles", [-1 -2 -3+1i -3+1i]}, "conjugate pairs, found [-1", ...
             {m, e, "output", "measured", "angle"}, "no constant feedback of angle was found", ...
             {m, e, "lqr", "measured", "angle", "observer", "none"}, "needs all 4 states", ...
             {m, e, "lqr", "limits", [1 2]}, "F is 0 at the trim, expected between its limits", ...
             {m, [1 2], "lqr"}, "expected the result of gsmbp_trim", ...
             {m, e, "lqr", "track", {"position", "angle"}}, "cannot hold position, angle", ...
             {sys, [], "lqg"}, "no gain makes the loop stable", ...
             {sys, [], "place", "poles", [-2 -3]}, "cannot be placed"}
    if (iscell (row{1}))
      given = row{1};
    else
      said = gsmbp_complaint (@() gsmbp_control (given{:}));
      gsmbp_check (["refused: " row{1}], ! isempty (strfind (said, row{1})));
    end
  end
  c = gsmbp_control (m, e, "lqr");
  said = gsmbp_complaint (@() with ("case_d6a", c));
  gsmbp_check ("refused: a continuous controller in a run", ...
               ! isempty (strfind (said, "has no period")));
  c = gsmbp_control (m, e, "lqr", "period", 0.01);
  c.measured{1} = "place";
  said = gsmbp_complaint (@() with ("case_d6a", c));
  gsmbp_check ("refused: a measurement that is no output", ...
               ! isempty (strfind (said, "expected the name of an output of the scene")));
  c = gsmbp_control (m, e, "lqr", "period", 0.01);
  d = c;
  d.name = "other";
  said = gsmbp_complaint (@() with ("case_d6a", {c, d}));
  gsmbp_check ("refused: two controllers of one input", ...
               ! isempty (strfind (said, "the input F has another device that holds it")));
end
