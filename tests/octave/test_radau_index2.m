## Collocation of Radau with loops in index 2 against dp853, or against itself with the equations
## with multipliers: a motor, redundant constraints, Euler parameters, stiff springs, feedback,
## samples, events; what is refused.

function test_radau_index2 ()
  warning ("off", "gsmbp:stiff", "local");
  warning ("off", "gsmbp:singular", "local");
  crank (gsmbp_fixture ("case_02a_motor"));
  redundant (gsmbp_fixture ("redundant_bricard"));
  small_rows (gsmbp_fixture ("redundant_tilted"));
  spring (gsmbp_fixture ("stiff_loop"));
  sampled (gsmbp_fixture ("sampled_crank"));
  rolls (gsmbp_fixture ("rolling_disc"));
  refused (gsmbp_fixture ("case_02a_motor"), gsmbp_fixture ("massless_bars"));
end

function varargout = index2 (m, x0, t, varargin)
  [varargout{1:nargout}] = gsmbp_simulate (m, x0, t, "method", "radau", "loops", "index2", ...
                                           varargin{:});
end

function r = truth (m, x0, t, varargin)
  r = gsmbp_simulate (m, x0, t, "rtol", 1e-13, "atol", 1e-13, varargin{:});
end

## a motor of 0.2 mH; every order; inputs of all kinds; an audit
function crank (m)
  m = gsmbp_set (m, "La", 2e-4);
  x0 = gsmbp_assemble (m, [0.3; -0.1; 0; zeros(4, 1)]);
  t = 0:0.05:0.5;
  exact = truth (m, x0, t, "input", 5);
  for order = [5, 9, 13]
    for k = 1:5
      r = index2 (m, x0, t, "input", 5, "rtol", 10 ^ -(2 * k), "maxorder", order);
      e(k) = state_gap (r, exact);
    end
    gsmbp_check (sprintf ("slider-crank, order %d: error over tolerance, 1e-2 to 1e-10", order), ...
                 e ./ 10 .^ -(2:2:10), 20);
  end
  gsmbp_check ("slider-crank: drift, m and m/s", [r.stats.drift.phi, r.stats.drift.phidot], 1e-14);
  other = gsmbp_simulate (m, x0, t, "input", 5, "method", "radau", "rtol", 1e-4);
  r = index2 (m, x0, t, "input", 5, "rtol", 1e-4);
  gsmbp_check ("slider-crank: not the steps of \"projection\"", state_gap (r, other) > 1e-12);
  wave = {"input", gsmbp_plan("table", [0, 0.131, 0.377, 0.5], [5; -5; 5; 5], 0), "audit", 1};
  r = index2 (m, x0, t, wave{:});
  exact = truth (m, x0, t, wave{1:2});
  gsmbp_check ("slider-crank: jumps of the input", state_gap (r, exact), 1e-8);
  gsmbp_check ("slider-crank: audit", r.audit.error, 1e-9);
  options = {"input", 1, "gain", [20, 0, 0, 4, 0, 0, 30], "reference", [0.1; zeros(6, 1)]};
  gsmbp_check ("slider-crank: state feedback", ...
               state_gap (index2 (m, x0, t, options{:}), truth (m, x0, t, options{:})), 1e-8);
  m = gsmbp_set (m, "La", 2e-6);
  [r, info] = gsmbp_simulate (m, x0, t, "input", 5, "method", "auto", "loops", "index2");
  gsmbp_check ("slider-crank: auto goes on with index 2", ...
               info == 0 && strcmp (r.stats.method, "radau"));
end

## four of five rows are independent
function redundant (m)
  closed = @(a) [a; acos(-cos (a) / (1 + cos (a)))]([1, 2, 1, 2, 1]);
  x0 = [closed(1); zeros(5, 1)];
  exact = truth (m, x0, 0:0.1:1);
  for k = 2:5
    r = index2 (m, x0, 0:0.1:1, "rtol", 10 ^ -(2 * k));
    e(k-1) = state_gap (r, exact) * 10 ^ (2 * k);
  end
  gsmbp_check ("Bricard: error over tolerance, 1e-4 to 1e-10", e, 20);
end

## rows that are nothing but rounding where the loop is closed
function small_rows (m)
  x0 = gsmbp_assemble (m, m.initial);
  exact = truth (m, x0, 0:0.05:0.2);
  for drift = [true, false]
    r = index2 (m, x0, 0:0.05:0.2, "drift", drift);
    gsmbp_check ("axes that are parallel by their numbers: all states", state_gap (r, exact), 1e-9);
  end
end

## steps that index 2 takes as "projection" does
function spring (m)
  m = gsmbp_set (m, "k", 1e11, "c", 1e7);
  x0 = gsmbp_assemble (m, m.initial, "hold", {"q1", "s"});
  t = 0:0.05:1;
  for rtol = [1e-4, 1e-8]
    other = gsmbp_simulate (m, x0, t, "method", "radau", "rtol", rtol / 10);
    r = index2 (m, x0, t, "rtol", rtol);
    gsmbp_check (sprintf ("spring of 1e11 N/m, rtol %g: error over tolerance (%d turns)", rtol, ...
                          r.stats.newton), state_gap (r, other) / rtol, 10);
  end
  m = gsmbp_set (m, "k", 1e6, "c", 1e3);
  w = gsmbp_workprecision (m, x0, [0, 0.02], "radau", 1e-4, "index2", [1e-4, 1e-6], "rk4", [], ...
                           "dp853", [], "print", false, "seconds", 0, "reference", 1e-10);
  gsmbp_check ("gsmbp_workprecision measures index 2", ...
               isequal ({w.method}, {"radau", "index2", "index2"}) && w(3).error < 1e-5);
end

function sampled (m)
  t = 0:0.02:0.2;
  exact = truth (m, m.initial, t, "start", "project");
  r = index2 (m, m.initial, t, "start", "project");
  gsmbp_check ("sampled crank: all states", state_gap (r, exact), 1e-8);
end

## constraints of speeds, Euler parameters
function rolls (m)
  t = 0:0.1:0.5;
  x0 = m.initial;
  x0(end) = 3;
  exact = truth (m, x0, t, "start", "project");
  r = index2 (m, x0, t, "start", "project");
  gsmbp_check ("a disc that rolls: all states", state_gap (r, exact), 1e-8);
end

function refused (m, massless)
  x0 = gsmbp_assemble (m, [0.3; -0.1; 0; zeros(4, 1)]);
  wrong = {{"method", "dp853"}, {"method", "cvode"}, {"method", "gauss"}, ...
           {"method", "radau", "projection", true}};
  for one = wrong
    said = "";
    try
      gsmbp_simulate (m, x0, [0, 1], "loops", "index2", one{1}{:});
    catch err
      said = err.message;
    end
    printf ("   (%s)\n", said);
    gsmbp_check (["refused: " one{1}{2}], strncmp (said, "gsmbp_simulate: ", 16));
  end
  x0 = gsmbp_assemble (massless, massless.initial);
  [~, info] = gsmbp_simulate (massless, x0, [0, 0.1], "method", "radau");
  [~, other] = index2 (massless, x0, [0, 0.1]);
  said = "";
  try
    index2 (massless, x0, [0, 0.1]);
  catch err
    said = err.message;
  end
  printf ("   (%s)\n", said);
  gsmbp_check ("bars without mass: told, the other way runs", ...
               info == 0 && other != 0 && ! isempty (strfind (said, "positive definite")));
end
