## Many runs: bit for bit those of gsmbp_set and gsmbp_simulate, whatever the number of threads and
## the order; loops, samples, events, all methods; runs that fail alone; refusals.

function test_ensemble ()
  warning ("off", "gsmbp:stiff", "local");
  axis = gsmbp_hand ("motor_pendulum");
  alike (axis);
  starts_and_inputs (axis);
  crank (gsmbp_fixture ("case_02a_motor"));
  closed (gsmbp_fixture ("case_02a_motor"));
  too_short (gsmbp_fixture ("driven_fourbar"));
  stepped (gsmbp_fixture ("sampled_drive"), gsmbp_fixture ("event_ball"));
  failing (axis);
  beyond (gsmbp_fixture ("stop_far"));
  refused (axis);
end

function same = alike_runs (e, m, x0, t, i, varargin)
  names = fieldnames (e.parameters)';
  values = cellfun (@(name) e.parameters.(name)(i), names, "UniformOutput", false);
  r = gsmbp_simulate (gsmbp_set (m, [names; values]{:}), x0, t, varargin{:});
  same = isequaln (r.x, e.x(:,:,i)) && isequaln (r.v, e.v(:,:,i)) && isequaln (r.y, e.y(:,:,i)) ...
           && r.stats.calls == e.calls(i);
end

function alike (m)
  n = 37;
  table = struct ("m", linspace (1, 1.5, n), "L_a", linspace (1e-3, 2e-3, n)(randperm (n)));
  t = 0:0.1:0.5;
  fixed = {"atol", 1e-10};
  for method = {{"dp853"}, {"rk4", "step", 1e-3}, {"radau"}, {"auto"}}
    options = [{"input", 3, "method"}, method{1}, fixed];
    e = gsmbp_ensemble (m, [0.2 0 0], t, options{:}, "parameters", table, "threads", 1);
    gsmbp_check ([method{1}{1} ": all come to their end"], ...
                 all (e.ok) && isequal (e.reached, 0.5 * ones (n, 1)) ...
                   && all (strcmp (e.reason, "")));
    same = arrayfun (@(i) alike_runs (e, m, [0.2 0 0], t, i, options{:}), [1, 8, n]);
    gsmbp_check ([method{1}{1} ": as by gsmbp_simulate, bit for bit"], all (same));
    order = randperm (n);
    shuffled = structfun (@(v) v(order), table, "UniformOutput", false);
    f = gsmbp_ensemble (m, [0.2 0 0], t, options{:}, "parameters", shuffled, "threads", 3);
    gsmbp_check ([method{1}{1} ": in another order, by three threads, bit for bit"], ...
                 isequal (f.x, e.x(:,:,order)) && isequal (f.v, e.v(:,:,order)));
  end
  gsmbp_check ("shapes", isequal (size (e.x), [6, 3, n]) && isequal (size (e.final), [n, 3]) ...
                 && isequal (e.of ("drive.i"), squeeze (e.x(:,3,:))) ...
                 && isequal (e.final(5,:), e.x(end,:,5)));
end

function starts_and_inputs (m)
  x0 = [0.2 0 0; 0.4 1 0; -0.3 0 1];
  v = [1; 2; 3];
  e = gsmbp_ensemble (m, [], [0, 0.3], "starts", x0, "inputs", v, "parameters", ...
                      struct ("m", [1, 1.2, 1.1]), "atol", 1e-10);
  for i = 1:3
    r = gsmbp_simulate (gsmbp_set (m, "m", e.parameters.m(i)), x0(i,:), [0, 0.3], "input", v(i), ...
                        "atol", 1e-10);
    same(i) = isequal (r.x, e.x(:,:,i)) && isequal (r.v, e.v(:,:,i));
  end
  gsmbp_check ("starts and inputs of each run, bit for bit", all (same));
end

## a longer rod: the start of each run must be closed anew
function crank (m)
  t = 0:0.1:0.5;
  x0 = gsmbp_assemble (m, [0.3; -0.1; 0; zeros(4, 1)]);
  e = gsmbp_ensemble (m, x0, t, "input", 5, "parameters", struct ("La", [0.02, 0.03]), "atol", ...
                      1e-10);
  gsmbp_check ("loops: bit for bit", all (e.ok) ...
                 && alike_runs (e, m, x0, t, 2, "input", 5, "atol", 1e-10));
  names = fieldnames (m.par);
  longer = struct (names{strcmp (names, "l2")}, m.par.l2 * [1, 1.01]);
  e = gsmbp_ensemble (m, x0, t, "input", 5, "parameters", longer);
  gsmbp_check (["loops: a start off its constraints is said: " e.reason{2}], ...
               e.ok(1) && ! e.ok(2) && all (isnan (e.x(:,:,2)(:))) ...
                 && ! isempty (strfind (e.reason{2}, "expected a state on the constraints at")));
  e = gsmbp_ensemble (m, x0, t, "input", 5, "parameters", longer, "start", "project");
  n = gsmbp_set (m, "l2", longer.l2(2));
  last = e.x(end,:,2)';
  [phi, ~, ~] = n.con (0.5, last(1:m.sizes.nq), last(m.sizes.nq+1:m.sizes.nq+m.sizes.nu));
  gsmbp_check ("loops: moved onto them where that is wanted, m", phi, 1e-12);
end

## in every way of the loops: starts are closed for the rods of their runs
function closed (m)
  t = [0, 0.1, 0.2];
  x0 = gsmbp_assemble (m, [0.3; -0.1; 0; zeros(4, 1)]);
  rods = struct ("l2", m.par.l2 * [1, 1 + 1e-8, 1 + 1e-4, 1.01]);
  for way = {"projection", "dp853"; "baumgarte", "dp853"; "baumgarte", "gauss"
             "partitioning", "dp853"; "partitioning", "radau"; "kane", "rk4"}'
    options = {"input", 5, "rtol", 1e-9, "atol", 1e-9, "loops", way{1}, "method", way{2}};
    what = [way{1} ", " way{2} ": "];
    e = gsmbp_ensemble (m, x0, t, options{:}, "parameters", rods, "lanes", false);
    gsmbp_check ([what "rods that do not fit: " e.reason{3}], ...
                 isequal (e.ok', [true, true, false, false]) ...
                 && all (strncmp (e.reason(3:4), "expected a state on the constr", 30)));
    gsmbp_check ([what "one that fits but for 1e-8"], alike_runs (e, m, x0, t, 2, options{:}));
    off = x0 + [0; 0.02; 0; zeros(4, 1)];
    for start = {x0, off}
      options = [options(1:10), {"start", "project"}];
      e = gsmbp_ensemble (m, start{1}, t, options{:}, "parameters", rods, "lanes", false);
      same = arrayfun (@(i) alike_runs (e, m, start{1}, t, i, options{:}), 1:4);
      gsmbp_check ([what "moved, bit for bit"], all (e.ok) && all (same));
    end
    e = gsmbp_ensemble (m, [], t, options{1:10}, "starts", [x0, off]', "lanes", false);
    gsmbp_check ([what "a start that is open"], isequal (e.ok', [true, false]));
  end
end

## no position closes the loop
function too_short (m)
  x0 = gsmbp_assemble (m, m.initial);
  for way = {"projection", "baumgarte", "partitioning"}
    e = gsmbp_ensemble (m, x0, [0, 0.1], "loops", way{1}, "parameters", ...
                        struct ("lc", m.par.lc * [1, 0.02]), "start", "project");
    gsmbp_check ([way{1} ": " e.reason{2}], ...
                 isequal (e.ok', [true, false]) && all (isnan (e.x(:,:,2)(:))) ...
                 && any (strfind (e.reason{2}, "no state on the constraints was found")));
  end
end

function stepped (drive, ball)
  t = 0:0.05:1;
  name = fieldnames (drive.par){1};
  e = gsmbp_ensemble (drive, [0; 0], t, "input", 1, "parameters", ...
                      struct (name, drive.par.(name) * [1, 1.1, 0.9]), "atol", 1e-10, "threads", ...
                      2, "lanes", false);
  gsmbp_check ("a digital controller: bit for bit", ...
               all (e.ok) && alike_runs (e, drive, [0; 0], t, 3, "input", 1, "atol", 1e-10));
  late = struct ("late", [0, 0.05, 0.35, 0.35], "period", [0.1, 0.1, 0.1, 0.02]);
  for lanes = [false, true]
    e = gsmbp_ensemble (drive, [0; 0], t, "input", 1, "parameters", late, "atol", 1e-10, ...
                        "lanes", lanes);
    gsmbp_check (sprintf ("delays of more periods than in the model, lanes %d", lanes), ...
                 all (e.ok) && alike_runs (e, drive, [0; 0], t, 4, "input", 1, "atol", 1e-10));
  end
  warning ("off", "gsmbp:failed", "local");
  for lanes = [false, true]   # 1e12 periods lie behind the start
    e = gsmbp_ensemble (drive, [0; 0], [1, 1.1], "input", 1, "parameters", ...
                        struct ("period", [0.1, 1e-12, 0.1]), "lanes", lanes);
    gsmbp_check (["samples beyond count: " e.reason{2}], isequal (e.ok', [true, false, true]) ...
                 && any (strfind (e.reason{2}, "expected at most 2e9 samples before the start")));
  end
  w = gsmbp_sweep (drive, [0; 0], t, "input", 1, "vary", struct ("late", [0.01, 0.5]), "runs", 8);
  gsmbp_check ("of a sweep", all (w.ok));
  name = fieldnames (ball.par){1};
  e = gsmbp_ensemble (ball, ball.initial, t, "parameters", ...
                      struct (name, ball.par.(name) * [1, 1.1, 0.9]), "atol", 1e-10, "threads", 2);
  gsmbp_check ("events: bit for bit", ...
               all (e.ok) && alike_runs (e, ball, ball.initial, t, 2, "atol", 1e-10));
end

## starts beyond a stop are refused as gsmbp_simulate refuses them, but where a mode says contact
function beyond (m)
  warning ("off", "gsmbp:failed", "local");
  x = [0.5, 0; -1, 0; 11, 0];
  for method = {"dp853", "rk4", "radau"}
    e = gsmbp_ensemble (m, x(1,:), [0, 1], "starts", x, "method", method{1});
    said = arrayfun (@(k) gsmbp_complaint (@() gsmbp_simulate (m, x(k,:), [0, 1])), 2:3, ...
                     "UniformOutput", false);
    gsmbp_check ([method{1} ": starts beyond a stop: " e.reason{2}], isequal (e.ok', [1, 0, 0]) ...
                 && all (cellfun (@(a, b) any (strfind (a, b)), said, e.reason(2:3)')) ...
                 && any (strfind (e.reason{2}, "beyond an end of the stop floor")));
  end
  e = gsmbp_ensemble (m, [0, 0], [0, 1], "starts", [0, 0; -1, 0], "modes", [-1, 0]);
  gsmbp_check ("... as simulated with modes", isequal (e.final(1,:), [0, 0]) && e.ok(1));
end

## each alone, with its reason
function failing (m)
  e = gsmbp_ensemble (m, [0.2 0 0], 0:0.1:1, "input", 3, "parameters", ...
                      struct ("J", [m.par.J, -1, m.par.J]), "atol", 1e-10);
  gsmbp_check (["parameters that cannot be: " e.reason{2}], ...
               isequal (e.ok, [true; false; true]) && all (isnan (e.x(:,:,2)(:))) ...
                 && isequal (e.x(:,:,1), e.x(:,:,3)) && ! isempty (e.reason{2}));
  e = gsmbp_ensemble (m, [0.2 0 0], 0:0.1:1, "input", 3, "parameters", struct ("m", [-1, 1.2, 0]));
  gsmbp_check (["rules of the scene: " e.reason{1}], isequal (e.ok, [false; true; false]) ...
                 && all (isnan (e.x(:,:,1)(:))) && all (isfinite (e.x(:,:,2)(:))) ...
                 && strcmp (e.reason{1}, "link arm must be above 0; found: m = -1, l = 0.5"));
  lastwarn ("");
  e = gsmbp_ensemble (m, [0.2 0 0], [0 0.1], "parameters", struct ("b", [0.1, -0.1]));
  [text, id] = lastwarn ();
  gsmbp_check (["what gives energy is a warning: " text], ...
               all (e.ok) && strcmp (id, "gsmbp:negative") ...
                 && ! isempty (strfind (text, "b = -0.1")));
  e = gsmbp_ensemble (m, [0.2 0 0], 0:0.1:1, "parameters", struct ("m", -1));
  gsmbp_check ("none that may run", ! e.ok && e.calls == 0);
  e = gsmbp_ensemble (m, [0.2 0 0], 0:0.1:1, "inputs", [3; 3e300; 3]);
  gsmbp_check (["a run that fails: " e.reason{2}], isequal (e.ok, [true; false; true]) ...
                 && e.reached(2) < 1 && ! isempty (e.reason{2}));
  e = gsmbp_ensemble (m, [0.2 0 0], 0:0.1:1, "inputs", [0; 20], "maxsteps", 12);
  gsmbp_check (["the limit of steps: " e.reason{2}], ...
               ! e.ok(2) && ! isempty (strfind (e.reason{2}, "maxsteps")) ...
                 && all (isnan (e.final(2,:))) && isfinite (e.x(1,1,2)));
end

function refused (m)
  wrong = {{}, "expected what differs from run to run";
           {"parameters", struct("M", 1)}, "unknown parameter \"M\", did you mean \"m\"";
           {"parameters", struct("m", [1, NaN])}, ...
            "parameter m: expected finite numbers, found NaN in row 2";
           {"parameters", struct("m", [1, 2], "l", 1)}, ...
            "parameter l: expected 2 values, one for each run as parameter m, found 1";
           {"parameters", struct("m", [])}, "parameter m: expected one value or more, found none";
           {"parameters", 3}, "expected a struct";
           {"starts", [1, 2]}, "option starts: expected rows of 3 numbers, found 2";
           {"inputs", [1, 2]}, "option inputs: expected rows of 1 numbers, found 2";
           {"inputs", 1, "threads", 0}, "option threads: expected a whole number";
           {"inputs", 1, "audit", 1}, "option audit is for one run alone";
           {"inputs", 1, "rtoll", 1}, "unknown option \"rtoll\", did you mean \"rtol\"";
           {"inputs", 1, "input", 2}, "give \"input\" or \"inputs\", not both";
           {"parameters", struct("m", 1), "input", @(t, x) 1}, "found a function of Octave"};
  for i = 1:rows (wrong)
    said = "";
    try
      gsmbp_ensemble (m, [0 0 0], [0, 1], wrong{i,1}{:});
    catch err
      said = err.message;
    end
    gsmbp_check (["refused: " said], strncmp (said, "gsmbp_ensemble: ", 16) ...
                   && ! isempty (strfind (said, wrong{i,2})));
  end
end
