## Runs in lanes: those of one run after the other but for rounding, and the same bits whatever the
## lane, the order, the number of threads and the runs beside; trees, loops, events, samples.

function test_lanes ()
  warning ("off", "gsmbp:stiff", "local");
  arm = gsmbp_fixture ("batch_arm");
  tree (arm);
  neighbours (arm);
  longest (arm);
  ends (arm);
  bound (arm);
  loop (gsmbp_fixture ("batch_bars"));
  through_flat (gsmbp_fixture ("batch_bars"));
  dependent (gsmbp_fixture ("lanes_dependent"));
  stepped (gsmbp_fixture ("batch_stop"), gsmbp_fixture ("sampled_drive"));
  held (gsmbp_fixture ("event_crank"), linspace (0, 2, 18), 0);
  held (gsmbp_fixture ("event_strut"), linspace (10, 60, 18), 3);
  late (gsmbp_fixture ("trim_integral"));
end

## columns of parameters, starts and inputs of N runs
function o = rows_of_arm (m, n)
  rand ("twister", 5);
  half = @(k) 2 * rand (n, k) - 1;
  o = {"starts", half(m.sizes.nx), "inputs", half(m.sizes.nv), "parameters", ...
       struct("m2", 17.4 + half (1), "f", 5 + half (1))};
end

function o = some (o, k)
  o{2} = o{2}(k,:);
  o{4} = o{4}(k,:);
  o{6} = structfun (@(x) x(k), o{6}, "UniformOutput", false);
end

function tree (m)
  n = 45;
  t = [0, 0.1, 0.15, 0.4];
  rows = rows_of_arm (m, n);
  for method = {{"dp853", "rtol", 1e-10, "atol", 1e-10}, {"rk4", "step", 2e-3}}
    o = [{"method"}, method{1}];
    e = gsmbp_ensemble (m, [], t, rows{:}, o{:}, "threads", 1);
    f = gsmbp_ensemble (m, [], t, rows{:}, o{:}, "lanes", false);
    name = method{1}{1};
    gsmbp_check ([name ": in lanes, all come to their end"], e.lanes && ! f.lanes && all (e.ok));
    gsmbp_check ([name ": as one after the other"], (e.x - f.x) ./ (1 + abs (f.x)), 1e-8);
    gsmbp_check ([name ": their inputs"], isequal (e.v, f.v));
    order = randperm (n);
    g = gsmbp_ensemble (m, [], t, some (rows, order){:}, o{:}, "threads", 3);
    gsmbp_check ([name ": in another order, by three threads, bit for bit"], ...
                 equal_runs (g, 1:n, e, order));
    g = gsmbp_ensemble (m, [], t, some (rows, 23){:}, o{:});
    gsmbp_check ([name ": alone, bit for bit"], g.lanes && equal_runs (g, 1, e, 23));
  end
end

## steps of rk4 are as long as "maxstep" lets them be, as those of single runs are
function longest (m)
  rows = rows_of_arm (m, 20);
  t = [0, 0.1, 0.25];
  o = {"method", "rk4", "threads", 1, "step"};
  e = gsmbp_ensemble (m, [], t, rows{:}, o{:}, 1, "maxstep", 2e-3);
  f = gsmbp_ensemble (m, [], t, rows{:}, o{:}, 2e-3);
  gsmbp_check ("rk4: no step beyond maxstep, in lanes", e.lanes && equal_runs (e, 1:20, f, 1:20));
  m = gsmbp_set (m, struct ("m2", rows{6}.m2(7), "f", rows{6}.f(7)));
  r = gsmbp_simulate (m, rows{2}(7,:), t, "input", rows{4}(7,:), o{[1, 2, 5]}, 1, "maxstep", 2e-3);
  gsmbp_check ("... as in a single run", ...
               [(e.x(:,:,7) - r.x)(:); e.accepted(7) - r.stats.accepted], 1e-12);
end

## runs that fail, or are far out, change nothing of those beside them
function neighbours (m)
  n = 20;
  rows = rows_of_arm (m, n);
  o = {"atol", 1e-9, "threads", 1};
  e = gsmbp_ensemble (m, [], [0, 0.2], rows{:}, o{:});
  bad = rows;
  bad{4}(3,1) = 3e300;
  bad{2}(7,1) = 2e5;
  bad{6}.m2(9) = -1;
  bad{2}(12,8) = 1e160;
  f = gsmbp_ensemble (m, [], [0, 0.2], bad{:}, o{:});
  good = setdiff (1:n, [3, 7, 9, 12]);
  gsmbp_check (["beside bad ones, bit for bit: " f.reason{3}], ...
               ! f.ok(3) && f.ok(7) && ! f.ok(9) && ! f.ok(12) ...
                 && equal_runs (e, good, f, good));
  g = gsmbp_ensemble (m, [], [0, 0.2], bad{:}, o{:}, "lanes", false);
  gsmbp_check ("as they end one after the other", ...
               isequal (f.ok, g.ok) && isequal (f.reason([3, 9]), g.reason([3, 9])));
end

function ends (m)
  rows = rows_of_arm (m, 18);
  e = gsmbp_ensemble (m, [], [0, 0.1, 0.5], rows{:}, "maxsteps", 30);
  f = gsmbp_ensemble (m, [], [0, 0.1, 0.5], rows{:}, "maxsteps", 30, "lanes", false);
  gsmbp_check (["the limit of steps: " e.reason{1}], ...
               ! all (e.ok) && isequal (e.ok, f.ok) && isequal (isnan (e.x), isnan (f.x)) ...
                 && ! isempty (strfind (e.reason{find (! e.ok, 1)}, "maxsteps")));
  e = gsmbp_ensemble (m, [], [0, 5], "starts", 30 * rows{2}, "method", "rk4", "step", 0.1);
  failed = ! e.ok;
  gsmbp_check (["runs that fail on the way say why: " e.reason{find(failed, 1)}], ...
               any (failed) && e.lanes && isequal (failed, ! strcmp (e.reason, "")) ...
                 && all (e.reached(failed) > 0));
  pp = mkpp ([0, 0.05, 0.2], [10, 0; -10, 0.5]);
  o = {"input", pp, "starts", rows{2}, "atol", 1e-11, "rtol", 1e-10};
  e = gsmbp_ensemble (m, [], [0, 0.1, 0.2], repmat_input (m, o){:});
  f = gsmbp_ensemble (m, [], [0, 0.1, 0.2], repmat_input (m, o){:}, "lanes", false);
  gsmbp_check ("inputs from a table with a jump", e.x - f.x, 1e-8);
  gsmbp_check ("those at the output times", isequal (e.v, f.v));
end

## steps of rk4 beyond what is stable for the motor's current: said of those runs that it breaks
function bound (m)
  n = 20;
  rows = rows_of_arm (m, n);
  rows{6}.M_L = m.par.M_L * [ones(10, 1); 0.2 * ones(10, 1)];
  pole = max (abs (eig (m.jac (0, rows{2}(1,:)', rows{4}(1,:)'))));
  o = {rows{:}, "method", "rk4", "step", 1.5 / pole};
  e = gsmbp_ensemble (m, [], [0, 300 / pole], o{:}, "threads", 1);
  f = gsmbp_ensemble (m, [], [0, 300 / pole], o{:}, "lanes", false);
  heard = @(e) ! cellfun ("isempty", strfind (e.reason, "the steps are bound by stability"));
  gsmbp_check (["unstable steps: " e.reason{20}], ...
               e.lanes && isequal (heard (e)(:), (1:n)' > 10) && isequal (heard (f), heard (e)) ...
                 && isequal (e.ok(:), (1:n)' <= 10));
end

## the polynomial for as many inputs as the model has
function o = repmat_input (m, o)
  [breaks, coefficients] = unmkpp (o{2});
  nv = m.sizes.nv;
  o{2} = mkpp (breaks, kron (coefficients, ones (nv, 1)), nv);
end

## every length of its own start
function loop (m)
  n = 18;
  t = [0, 0.2, 0.5];
  lc = linspace (0.49, 0.52, n);
  table = struct ("lc", lc, "lb", linspace (0.69, 0.7, n));
  for way = {{"dp853", "rtol", 1e-9, "atol", 1e-9}, {"rk4", "step", 2e-3}}
    o = [{"input", [12; 0.5](1:m.sizes.nv), "parameters", table, "start", "project", "method"}, ...
         way{1}];
    e = gsmbp_ensemble (m, m.initial, t, o{:}, "threads", 1);
    f = gsmbp_ensemble (m, m.initial, t, o{:}, "lanes", false);
    name = way{1}{1};
    gsmbp_check ([name ": loops in lanes"], e.lanes && all (e.ok) && all (f.ok));
    gsmbp_check ([name ": as one after the other"], e.x - f.x, 1e-6);
    g = gsmbp_ensemble (m, m.initial, t, o{1:2}, "parameters", ...
                        structfun (@(x) flip (x), table, "UniformOutput", false), o{5:end}, ...
                        "threads", 2);
    gsmbp_check ([name ": in another order, by two threads, bit for bit"], ...
                 equal_runs (g, n:-1:1, e, 1:n));
  end
  h = gsmbp_ensemble (m, m.initial, [0, 0.01], o{1:2}, "start", "project", "loops", "nullspace", ...
                      "parameters", struct ("lc", lc));
  gsmbp_check ("a way of the loops that is that of one run has no lanes", ! h.lanes && all (h.ok));
end

## one run is a parallelogram that falls through its flat position, where the constraints lose rank
function through_flat (m)
  n = 18;
  t = [0, 0.2, 0.9];
  starts = repmat (m.initial', n, 1);
  starts(4,4:6) = [-12, 12, -12];
  table = struct ("lc", linspace (0.49, 0.52, n), "lb", linspace (0.69, 0.7, n));
  flat = table;
  [flat.lc(4), flat.lb(4)] = deal (m.par.la, m.par.ld);
  others = setdiff (1:n, 4);
  input = mkpp ([0, 1], [5, -15; 1, -1](1:m.sizes.nv,:), m.sizes.nv);
  for way = {{"dp853", "rtol", 1e-9, "atol", 1e-9}, {"rk4", "step", 2e-3}; 1e-7, 1e-10}
    run = @(table, varargin) gsmbp_ensemble (m, [], t, "starts", starts, "parameters", table, ...
                                             "input", input, "start", "project", "method", ...
                                             way{1}{:}, varargin{:});
    e = run (flat, "threads", 1);
    f = run (flat, "lanes", false);
    name = way{1}{1};
    gsmbp_check ([name ": a run passes a singular position"], e.lanes && all (e.ok) ...
                 && e.x(1,1,4) > 0.1 && e.x(end,1,4) < -0.1);
    gsmbp_check ([name ": ... as it does alone"], e.x(:,:,4) - f.x(:,:,4), way{2});
    gsmbp_check ([name ": ... and changes nothing of those beside it, bit for bit"], ...
                 equal_runs (e, others, run (table, "threads", 1), others));
  end
end

## three equal cranks turn a bar; steps of a run with dependent constraints are not those in lanes:
## I a = 1 - 2 t N m, in closed form
function dependent (m)
  n = 18;
  speed = linspace (0.5, 1.5, n)';
  l = linspace (0.4, 0.6, n)';
  t = [0, 0.2, 0.5];
  turned = 1 + speed * t + (t .^ 2 / 2 - t .^ 3 / 3) ./ (0.3 + 2 * l .^ 2);
  starts = [ones(n, 1) * [1, -1, 1, 1], speed * [1, -1, 1, 1]];
  for method = {{"dp853", "rtol", 1e-11, "atol", 1e-11}, {"rk4", "step", 2e-3}}
    e = gsmbp_ensemble (m, [], t, "starts", starts, "input", mkpp ([0, 1], [-2, 1]), ...
                        "parameters", struct ("l", l, "l3", l, "l4", l), "method", method{1}{:});
    gsmbp_check ([method{1}{1} ": dependent constraints"], e.lanes && all (e.ok));
    gsmbp_check ([method{1}{1} ": ... in closed form"], squeeze (e.x(:,1,:))' - turned, 1e-9);
  end
end

function stepped (m, drive)
  n = 18;
  x0 = m.initial;
  x0(3) = 1;
  o = {"parameters", struct("g", linspace (9, 10, n)), "atol", 1e-10};
  e = gsmbp_ensemble (m, x0, 0:0.25:1.5, o{:}, "threads", 1);
  f = gsmbp_ensemble (m, x0, 0:0.25:1.5, o{:}, "lanes", false);
  gsmbp_check ("events", e.x - f.x, 1e-7);
  gsmbp_check ("events: in lanes", e.lanes);
  gsmbp_check ("events: all come to their end", all (e.ok) && all (f.ok));
  o = {"input", 1, "parameters", struct("period", linspace (0.05, 0.1, n)), "atol", 1e-10};
  e = gsmbp_ensemble (drive, [0; 0], 0:0.05:1, o{:});
  f = gsmbp_ensemble (drive, [0; 0], 0:0.05:1, o{:}, "lanes", false);
  gsmbp_check ("samples", e.x - f.x, 1e-9);
  gsmbp_check ("samples: all come to their end", e.lanes && all (e.ok));
  gsmbp_check ("what is held", e.v - f.v, 1e-6);
end

## ports that stick and hit stops, in a loop too: an effort for every run, by some of which nothing
## moves; still: in how many at least
function held (m, efforts, still)
  n = numel (efforts);
  t = 0:0.1:1;
  o = {"inputs", efforts', "rtol", 1e-9, "atol", 1e-10};
  if (m.sizes.nlam > 0)
    o = [o, {"start", "project"}];
  end
  e = gsmbp_ensemble (m, m.initial, t, o{:}, "threads", 1);
  f = gsmbp_ensemble (m, m.initial, t, o{:}, "lanes", false);
  gsmbp_check ([m.name ": held ports in lanes"], e.lanes && all (e.ok) && all (f.ok));
  gsmbp_check ([m.name ": as one after the other"], (e.x - f.x) ./ (1 + abs (f.x)), 1e-7);
  moved = squeeze (max (abs (e.x(end,1:m.sizes.nq,:) - e.x(1,1:m.sizes.nq,:)), [], 2));
  gsmbp_check ([m.name ": some stick, others slide"], ...
               sum (moved < 1e-9) >= still && any (moved > 1e-3));
  one = gsmbp_simulate (m, m.initial, t, "input", efforts(end), o{3:end});
  gsmbp_check ([m.name ": as a run by itself"], ...
               (e.x(:,:,end) - one.x) ./ (1 + abs (one.x)), 1e-7);
  o{2} = flipud (o{2});
  g = gsmbp_ensemble (m, m.initial, t, o{:}, "threads", 2);
  gsmbp_check ([m.name ": in another order, by two threads, bit for bit"], ...
               equal_runs (g, n:-1:1, e, 1:n));
end

## devices whose rates read accelerations and multipliers
function late (m)
  n = 18;
  t = [0, 0.1, 0.4];
  o = {"parameters", struct("w", linspace (4, 8, n)), "rtol", 1e-10, "atol", 1e-11, "start", ...
       "project"};
  e = gsmbp_ensemble (m, m.initial, t, o{:});
  f = gsmbp_ensemble (m, m.initial, t, o{:}, "lanes", false);
  gsmbp_check ("sensors of forces with a lag: in lanes", e.lanes && all (e.ok) && all (f.ok));
  gsmbp_check ("sensors of forces: as one after the other", ...
               (e.x - f.x) ./ (1 + abs (f.x)), 1e-8);
end
