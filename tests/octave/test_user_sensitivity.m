## Derivatives by parameters through events of the user: a bouncing ball against the closed form by
## complex steps; switches, Euler parameters, states of devices, stops of the library, closed chains
## against differences of runs; what has no derivative; the stop; an optimum over events.

function test_user_sensitivity ()
  ball ();
  kinds ();
  planned ();
  kick ();
  pair ();
  none_actuated ();
  left_open ();
  grazing ();
  refused ();
end

## height and speed at T, and the times of the bounces, of a ball from Y with the speed V; at a time
## between events these are analytic functions
function [y, v, at] = flight (g, e, lo, y, v, T)
  [now, at] = deal (0, []);
  do
    fall = (v + sqrt (v ^ 2 + 2 * g * (y - lo))) / g;
    if (real (now + fall) > T)
      break;
    end
    now += fall;
    at(end+1,1) = now;
    [y, v] = deal (lo, e * (g * fall - v));
  until (false)
  left = T - now;
  y += v * left - g * left ^ 2 / 2;
  v -= g * left;
end

function ball ()
  m = gsmbp_fixture ("sensitivity_bounce");
  names = {"g", "e", "lo", "y", "y_d"};
  start = [9.81, 0.8, 0.1, 1, 0.3];
  times = [0, 0.3, 1, 2, 2.4];
  for method = {"dp853", "rk4", "radau", "gauss", "cvode"}
    r = gsmbp_simulate (m, start(4:5)', times, "sensitivity", [names, {"last"}], ...
                        "method", method{1}, "step", 0.02);
    loose = 1 + 1e5 * strcmp (method{1}, "cvode");
    hits = strcmp (r.events.name, "hit");
    [off, late] = deal (0);
    for k = 1:5
      p = num2cell (start + 1e-30i * ((1:5) == k));
      for j = 2:5
        [y, v, at] = flight (p{:}, times(j));
        off = max ([off, abs(imag ([y, v]) / 1e-30 - r.dx.(names{k})(j,:))]);
      end
      late = max ([late; abs(imag (at) / 1e-30 - r.events.dt.(names{k})(hits))]);
    end
    gsmbp_check (["ball, heights and speeds up to four bounces, " method{1}], off, ...
                 1e-12 * loose);
    gsmbp_check (["ball, times of the bounces, " method{1}], late, 1e-13 * loose);
    gsmbp_check (["ball, events, " method{1}], [sum(hits), sum(! hits)] == [4, 5]);
  end
  gsmbp_check ("nothing is by what comes later", max (abs (r.dx.last(:))), 0);
  ended (m, start);
end

## a run that an event ends: its time is told, the state's derivatives are those at a fixed time
function ended (m, start)
  m = gsmbp_set (m, "last", 2.2);
  r = gsmbp_simulate (m, start(4:5)', [0 1 5], "sensitivity", {"last", "e"});
  gsmbp_check ("it ends when it should", [r.t(end), r.events.dt.last(end)] - [2.2, 1], 1e-12);
  gsmbp_check ("other parameters do not move the end", r.events.dt.e(end), 0);
  [~, v] = flight (num2cell (start + [0, 1e-30i, 0, 0, 0]){:}, 2.2);
  gsmbp_check ("the end's state by e, at a fixed time", r.dx.e(end,2) - imag (v) / 1e-30, 1e-9);
end

function kinds ()
  m = gsmbp_fixture ("sensitivity_user");
  x = zeros (m.sizes.nx, 1);
  [~, at] = ismember ({"x_d", "e0", "e1", "e2", "wx", "wy", "wz", "p3", "p3_d", "y", "y_d"}, ...
                      m.states);
  x(at) = [1.3, cos(0.3), 0.6 * sin(0.3), 0.8 * sin(0.3), 1, 2, 0.4, 0.1, 1, 0.3, 1.7];
  names = {"g", "c", "power", "px", "e", "k", "ke", "level", "b"};
  compare ("every kind", m, @(m) x, [0 0.7 1.1 1.6 2.2], names, {"input", [0.5 2.5]}, {}, 1e-8);
  gain = [zeros(1, 9), 0.2, zeros(1, 8); zeros(2, 18)];
  compare ("with feedback until it is switched", m, @(m) x, [0 0.3 0.6 1.1], {"low", "c", "b"}, ...
           {"input", [0.5 2.5], "gain", gain, "reference", x}, {}, 1e-8);
end

## events that read inputs: of a planned motion, with feedback, of a function of time
function planned ()
  m = gsmbp_fixture ("sensitivity_planned");
  t = linspace (0, 2, 41);
  motion = spline (t, 0.8 * sin (2 * t));
  names = {"g", "l", "limit", "b", "big", "c"};
  times = [0 0.6 1 1.5];
  compare ("planned", m, @(m) [0; 1.6], times, names([1, 2, 5, 6]), {"motion", motion}, {}, 1e-9);
  compare ("planned, feedback", m, @(m) [0; 1.6], times, names(1:4), ...
           {"motion", motion, "gain", [5 0.5], "reference", [0 0]}, {}, 1e-9);
  compare ("function of time", m, @(m) [0; 1.6], times, names(1:4), ...
           {"input", @(t, x) 9.2 * sin(3 * t) + 1}, {}, 1e-9);
end

## two balls that bounce at one instant: by what moves both alike there is a derivative
function pair ()
  m = gsmbp_fixture ("sensitivity_pair");
  warning ("off", "gsmbp:derivative", "local");
  names = {"g", "e", "a", "b"};
  r = gsmbp_simulate (m, [1; 1; 0; 0], [0 1 1.5], "sensitivity", names);
  [y, v] = flight (9.81 + 1e-30i, 0.8, 0, 1, 0, 1.5);
  gsmbp_check ("both bounces by g", r.dx.g(3,:) - imag ([y, y, v, v]) / 1e-30, 1e-10);
  gsmbp_check ("what moves them apart is told", isequal ({r.stats.lost.name}, names(2:4)) ...
               && norm ([r.stats.lost.time] - sqrt (2 / 9.81) * [2.6, 1, 1]) < 1e-9);
  gsmbp_check ("and is no number", isnan (r.dx.a(2,2)) && isnan (r.dx.b(2,1)) ...
               && isfinite (r.dx.e(2,1)) && isnan (r.dx.e(3,1)));
end

function kick ()
  m = gsmbp_fixture ("sensitivity_kick");
  start = @(m) gsmbp_assemble (m, [0.5 -0.6 0.38 3 0 0]', "hold", "phi");
  names = {"m", "l", "early", "kicked", "by", "place", "jump", "limit"};
  compare ("crank", m, start, [0 0.1 0.3 0.5], names, {"input", 3}, {"fixed", "phi"}, 1e-7);
end

## dx, dv and times of events beside differences of runs, each beside its largest value
function compare (what, m, start, t, names, given, fixed, tolerance)
  r = gsmbp_simulate (m, start (m), t, "sensitivity", names, "rtol", 1e-12, given{:}, fixed{:});
  off = 0;
  for p = names
    h = 1e-4 * m.par.(p{1});
    run = @(s) gsmbp_simulate (gsmbp_set (m, p{1}, m.par.(p{1}) + s * h), ...
                               start (gsmbp_set (m, p{1}, m.par.(p{1}) + s * h)), t, ...
                               "rtol", 1e-13, given{:});
    both = @(q) [q.x(:); q.v(:); q.events.t];
    g = @(s) both (run (s));
    D = (8 * (g(1) - g(-1)) - (g(2) - g(-2))) / (12 * h);
    found = [r.dx.(p{1})(:); r.dv.(p{1})(:); r.events.dt.(p{1})];
    off = max (off, norm (found - D, Inf) / norm (D, Inf));
  end
  gsmbp_check (sprintf ("%s, %d events: as by differences", what, numel (r.events.t)), off, ...
               tolerance);
end

## loops without a motor: which coordinates keep their place at the start is to be said
function none_actuated ()
  m = gsmbp_fixture ("sensitivity_kick");
  x = gsmbp_assemble (m, [0.5 -0.6 0.38 3 0 0]', "hold", "phi");
  m.actuated = zeros (0, 1);   # as where a torque takes the place of the motor
  said = gsmbp_complaint (@() gsmbp_simulate (m, x, [0 0.1], "input", 3, "sensitivity", "m"));
  gsmbp_check (["no coordinate is actuated: " said], ...
               any (strfind (said, "option fixed: expected 1 of the coordinates, those")) ...
               && any (regexp (said, "found none$")));
end

## a place of a crank that is set alone: the speeds are the projection's choice
function left_open ()
  m = gsmbp_set (gsmbp_fixture ("sensitivity_kick"), "late", 1.5, "place", 0);
  x = gsmbp_assemble (m, [0.5 -0.6 0.38 3 0 0]', "hold", "phi");
  warning ("off", "gsmbp:derivative", "local");
  r = gsmbp_simulate (m, x, [0 0.1 0.3], "input", 3, "sensitivity", "m", "fixed", "phi");
  gsmbp_check ("what has no derivative is named", strcmp (r.stats.lost.event, "loose") ...
               && ! isempty (strfind (r.stats.lost.text, "leave a choice")));
  gsmbp_check ("and is no number", all (isnan (r.dx.m(3,:))) && all (isfinite (r.dx.m(2,:))) ...
               && isnan (r.events.dt.m(end)));
end

## a body that is thrown up to a floor where it just turns
function grazing ()
  m = gsmbp_fixture ("sensitivity_user");
  x = zeros (m.sizes.nx, 1);
  [~, at] = ismember ({"e0", "p3_d"}, m.states);
  x(at) = 1;
  warning ("off", "gsmbp:derivative", "local");
  run = @(floor) gsmbp_simulate (gsmbp_set (m, "floor", floor), x, [0 0.05 0.2], "input", ...
                                 [0 1], "sensitivity", "g");
  top = 1 / (2 * 9.81);
  gsmbp_check ("a fall through the floor has its derivative", isempty (run (0.9 * top).stats.lost));
  lost = run (top - 1e-13).stats.lost;
  gsmbp_check ("a top at the floor has none", strcmp (lost.event, "land") ...
               && ! isempty (strfind (lost.text, "grazes")));
  lost = run (top + 1e-13).stats.lost;
  gsmbp_check ("nor one just below", strcmp (lost.event, "land"));
end

function refused ()
  m = gsmbp_fixture ("user_bounce");
  said = gsmbp_complaint (@() gsmbp_simulate (m, [1 0], [0 1], "sensitivity", "g"));
  gsmbp_check ("a model without the request", ! isempty (strfind (said, "without the subroutine")));
end
