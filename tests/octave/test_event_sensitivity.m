## Derivatives by parameters along runs with events: a bouncing ball and a block that sticks to a
## belt against derivatives of closed forms of 50 digits; trees and loops with friction and stops
## against differences of runs; what has no derivative; the emitted subroutines.

function test_event_sensitivity ()
  ball ();
  belt ();
  arm ();
  guide ();
  grazing ();
  on_a_stop ();
  several ();
  samples ();
  cart ();
end

## columns: height, speed; rows: by g, lo, e and the start, at 0.3, 1, 2, 2.4 s (none, one, three,
## four impacts)
function t = ball_table ()
  t = [
       -4.499999999999999833e-02, -2.999999999999999889e-01
       0, 0
       0, 0
       1.000000000000000000e+00, 0
       2.999999999999999889e-01, 1.000000000000000000e+00
       -1.018982443226717077e-01, -6.154610779702776036e-01
       -4.632946094474001408e-01, -4.191474250123974343e+00
       2.274830259852330894e+00, 4.212837523570070353e+00
       1.463294609447400196e+00, 4.191474250123974343e+00
       2.411703201231492344e-01, 1.128179640676574058e+00
       -8.509927648485603180e-02, -1.061725030247477219e+00
       -1.141160173541536788e-01, -1.022719717030249775e+01
       4.277244159251897493e+00, 2.999540316781889970e+01
       1.114116017354153776e+00, 1.022719717030249775e+01
       1.173753722412333028e-01, 1.312758323250840853e+00
       -1.069589096237880815e-01, -1.264841102168259512e+00
       -2.507976680010862713e-01, -1.237323198636597255e+01
       5.606328567125554940e+00, 4.671194246134493255e+01
       1.250797668001086160e+00, 1.237323198636597255e+01
       1.257804113311317140e-01, 1.378386299277246874e+00
      ];
end

function ball ()
  m = gsmbp_fixture ("sensitivity_ball");
  names = {"g", "lo", "e", "y1", "y1_d"};
  for method = {"dp853", "rk4", "radau", "gauss", "cvode", "auto"}
    r = gsmbp_simulate (m, [1 0 0.3 0], [0 0.3 1 2 2.4], "sensitivity", names, "method", method{1});
    off = off_table (r, names, ball_table (), @(x) x(:,[1, 3]));
    gsmbp_check (["ball, " method{1} ": dx/dp through four impacts"], off, ...
                 1e-10 + 1e-8 * strcmp (method{1}, "cvode"));
  end
  at = @(m) gsmbp_simulate (m, [1 0 0.3 0], [0 2], "rtol", 1e-13).y(2,:);
  r = gsmbp_simulate (m, [1 0 0.3 0], [0 2], "sensitivity", {"m", "g"});
  D = [differenced(at, m, "m"); differenced(at, m, "g")];
  gsmbp_check ("ball: dy/dp of the reaction", norm ([r.dy.m(2,:); r.dy.g(2,:)] - D) < 1e-9);
  ## it comes to rest on the floor: then it is where that is
  r = gsmbp_simulate (gsmbp_set (m, "vr", 0.5), [1 0 0 0], [0 6], ...
                      "sensitivity", {"lo", "e", "y1"});
  gsmbp_check ("ball at rest: its place follows the floor alone", ...
               max (abs ([r.dx.lo(2,:) - [1 0 0 0], r.dx.e(2,:), r.dx.y1(2,:)])) < 1e-12 ...
               && r.v(end,1) == -1);
end

## columns: place and speed of the block; rows: by m, k, fc, vb, at 0.1, 0.3, 1, 1.5 s: it slides
## backward, sticks, slides
function t = belt_table ()
  t = [
       4.520524992411500791e-03, 9.281018223798102873e-02
       -1.957520844110766719e-04, -4.577295797458269012e-03
       -2.491677769844796286e-03, -4.966733269876530410e-02
       0, 0
       1.873506222795078002e-02, 0
       -1.016470201064589244e-03, 0
       -9.779454282461616521e-03, 0
       1.009050434122547996e-01, 1.000000000000000000e+00
       2.470110322224575855e-02, 5.402341864472468697e-02
       -2.033428512280096787e-02, -9.055616480957438819e-02
       3.775735817930540861e-02, 2.054674937290485726e-01
       6.190165362457604736e-01, 8.701797475151261396e-02
       8.834723952333779773e-02, 1.873585597241061718e-01
       -8.370308485633953799e-02, -1.435292139696355551e-01
       1.643100666013469213e-01, 2.578388641029573658e-01
       3.710676123591652997e-01, -9.947528963239682387e-01
      ];
end

function belt ()
  m = gsmbp_fixture ("sensitivity_belt");
  names = {"m", "k", "fc", "vb"};
  for method = {"dp853", "radau", "gauss", "cvode"}
    r = gsmbp_simulate (m, [0; 0.05; 0.5; 0.4], [0 0.1 0.3 1 1.5], "sensitivity", names, ...
                        "fixed", "s", "dx0", [0 0 0 0; 0 0 0 0; 0 0 0 1; 0 0 0 -1], ...
                        "method", method{1}, "step", 3e-4 * strcmp (method{1}, "gauss"));
    gsmbp_check (["belt: it sticks and breaks away, " method{1}], isequal (r.events.mode, [0; -1]));
    off = off_table (r, names, belt_table (), @(x) [x(:,1) + x(:,2), x(:,3) + x(:,4)]);
    gsmbp_check (["belt, " method{1} ": dx/dp beside 50 digits"], off, ...
                 1e-10 + 1e-8 * strcmp (method{1}, "cvode"));
  end
end

function off = off_table (r, names, t, of)
  off = 0;
  for k = 1:numel (names)
    found = of (r.dx.(names{k}))(2:end,:);
    wanted = t(k:numel (names):end,:);
    off = max (off, max (max (abs (found - wanted) ./ max (1, abs (wanted)))));
  end
end

function D = differenced (f, m, p)
  h = 1e-4 * m.par.(p);
  g = @(s) f (gsmbp_set (m, p, m.par.(p) + s * h));
  D = (45 * (g(1) - g(-1)) - 9 * (g(2) - g(-2)) + (g(3) - g(-3))) / (60 * h);
end

## a double pendulum: impacts at the elbow, both joints stick and slide
function arm ()
  m = gsmbp_fixture ("sensitivity_arm");
  compare ("arm", m, @(m) [1.5; 0.3; 0; 5], [0 0.3 1 2], {"m1", "l", "hi", "e", "f1", "f2"}, {}, ...
           {"input", mkpp([0 3], [0.4 -0.5])}, 1e-8);
end

## a slider-crank whose slider hits a stop and has friction in its guide
function guide ()
  m = gsmbp_fixture ("sensitivity_guide");
  start = @(m) gsmbp_assemble (m, [0.3; -0.1; 0; 2; 0; 0], "hold", "theta");
  compare ("slider-crank", m, start, [0 0.1 0.3 0.8], {"m", "l", "lo", "e", "fc"}, ...
           {"fixed", "theta"}, {"input", 0.5}, 1e-8);
end

function compare (what, m, start, t, names, fixed, input, tolerance)
  r = gsmbp_simulate (m, start (m), t, "sensitivity", names, "rtol", 1e-12, fixed{:}, input{:});
  at = @(m) gsmbp_simulate (m, start (m), t, "rtol", 1e-13, input{:});
  both = @(q) [q.x(end,:), q.y(end,:)];
  n = numel (r.events.t);
  printf ("   %s: events %s\n", what, num2str (r.events.number'));
  for p = names
    D = differenced (@(m) both (at (m)), m, p{1});
    e = norm ([r.dx.(p{1})(end,:), r.dy.(p{1})(end,:)] - D, Inf) / norm (D, Inf);
    gsmbp_check (sprintf ("%s, %d events: dx, dy by %s as by differences, found %.2g", what, n, ...
                          p{1}, e), e < tolerance);
  end
end

## motions that only touch: none, two, three digits around it, and one that misses the floor
function grazing ()
  m = gsmbp_set (gsmbp_fixture ("sensitivity_ball"), "g", -9.81, "lo", -2);
  for off = [0, 1e-9, -1e-11]
    x0 = [0 0 -sqrt(4*9.81)*(1+off) 0];
    [r, said] = warned (@() gsmbp_simulate (m, x0, [0 0.2 1], "sensitivity", {"g", "e"}));
    gsmbp_check (sprintf ("grazing the floor within %g: told by name, no numbers from there on", ...
                          off), ...
                 all (isnan (r.dx.g(3,:))) && all (isnan (r.dy.g(3,:))) ...
                 && all (isfinite (r.dx.g(2,:))) ...
                 && abs (r.stats.lost(1).time - sqrt (4 / 9.81)) < 1e-3 ...
                 && ! isempty (strfind (said, "no derivatives by g, e from t = 0.6385")) ...
                 && ! isempty (strfind (said, "event of floor")) ...
                 && ! isempty (strfind (said, "only grazes")));
  end
  r = gsmbp_simulate (m, [0, 0, -sqrt(4*9.81)*(1-1e-6), 0], [0 1], "sensitivity", "g");
  gsmbp_check ("passing above the floor is none", r.dx.g(2,:) - [-0.5 0 -1 0], 1e-12);
  m = gsmbp_fixture ("sensitivity_belt");
  [r, said] = warned (@() gsmbp_simulate (m, [0 0 0.5 0], [0 3 5], "sensitivity", "k", ...
                                          "fixed", "s"));
  gsmbp_check ("friction that comes to rest just not", ...
               all (isnan (r.dx.k(3,:))) && ! isempty (strfind (said, "event of rub")));
end

## a start at rest on a stop that moves with a parameter
function on_a_stop ()
  m = gsmbp_fixture ("sensitivity_ball");
  run = @(varargin) gsmbp_simulate (m, [0.1 0 0 0], [0 1], "sensitivity", varargin{:});
  text = gsmbp_complaint (@() run ("lo"));
  gsmbp_check (["a start on a stop that moves with a parameter: " text], ...
               ! isempty (strfind (text, "starts on the stop floor")));
  gsmbp_check ("... and where the start moves with it", ...
               run ("lo", "dx0", [1; 0; 0; 0]).dx.lo(2,:) - [1 0 0 0], 1e-12);
  gsmbp_check ("... and by what does not move it", run ("e").dx.e(2,:), 1e-12);
end

## a ball and a puck that hit at the same instant, which a parameter takes apart, and one does not
function several ()
  m = gsmbp_fixture ("sensitivity_ball");
  hit = (0.3 + sqrt (0.09 + 2 * 9.81 * 0.9)) / 9.81;
  x0 = [1 0 0.3 2/hit];
  [r, said] = warned (@() gsmbp_simulate (m, x0, [0 0.3 0.7], "sensitivity", {"lo", "e"}));
  gsmbp_check ("two events at one instant: told, no numbers where their times move apart", ...
               all (isnan (r.dx.lo(3,:))) ...
               && ! isempty (strfind (said, "another event at the same instant")));
  gsmbp_check ("... and numbers where they do not", ...
               [r.dx.e(3,3), r.dx.e(3,4)] - [9.81 * hit - 0.3, -2/hit], 1e-9);
end

## a wheel under a digital PI controller, output at once or delayed, against its recursion by
## complex steps; the last run ends at an event, which adds a part of the held torque to the speed,
## and at a sample, which belongs to a run from there on
function samples ()
  m = gsmbp_fixture ("sensitivity_sampled");
  names = {"J", "kp", "ki"};
  for late = [0, 0.03]
    m = gsmbp_set (m, "late", late);
    run = @(m, t) gsmbp_simulate (m, [0; 0.1], t, "sensitivity", [names, "q_d"], "input", [2; 0]);
    r = run (m, [0 0.25 0.57]);
    at_end = run (gsmbp_set (gsmbp_fixture ("sensitivity_clock"), "late", late), [0 0.6]);
    gsmbp_check ("the run has the event at its end", at_end.events.t - 0.6, 1e-15);
    p0 = [m.par.J, m.par.kp, m.par.ki, 0.1];
    for i = 1:4
      p = p0;
      p(i) += 1e-30i;
      D = imag ([recursion(p, late, 0.25); recursion(p, late, 0.57); ...
                 recursion(p, late, 0.6 - eps) * [1, 0; 0.01, 1]]) / 1e-30;
      name = [names, "q_d"]{i};
      found = [r.dx.(name)(2:3,2), r.dy.(name)(2:3,1); ...
               at_end.dx.(name)(2,2), at_end.dy.(name)(2,1)];
      gsmbp_check (sprintf ("digital PI, %g s late: speed and torque by %s", late, name), ...
                   max (max (abs (found - D) ./ max (1, abs (D)))) < 1e-10);
    end
  end
  says = @(f, text) gsmbp_check (["refused: " text], any (strfind (gsmbp_complaint (f), text)));
  says (@() gsmbp_simulate (m, [0; 0], [0 1], "sensitivity", "period"), ...
        "period moves the instants of sampled devices");
  says (@() gsmbp_adjoint (m, [0; 0], [0 1], @(r) deal (1, 1)), "no adjoint through samples");
end

## [speed, torque] at T
function y = recursion (p, late, T)
  [J, kp, ki, w] = num2cell (p){:};
  [I, now, next, t] = deal (0, 0, 0, 0);
  for k = 0:9
    e = 2 - w;
    if (0.1 * k > T)
      break;
    end
    next = kp * e + I;
    I += ki * 0.1 * e;
    part = max (0, min (T, 0.1 * k + late) - 0.1 * k);
    w += now / J * part;
    if (T > 0.1 * k + late)
      now = next;
      w += now / J * (min (T, 0.1 * (k + 1)) - 0.1 * k - late);
    end
  end
  y = [w, now];
end

## a cart with dry friction under a digital controller, a pendulum on it that hits a stop
function cart ()
  m = gsmbp_fixture ("sensitivity_cart");
  compare ("cart", m, @(m) [0.1; 2; 0; 0], [0 0.3 0.71], {"mc", "fc", "e", "kp"}, {}, {}, 1e-8);
end

function [r, said] = warned (f)
  lastwarn ("");
  r = f ();
  said = lastwarn ();
end
