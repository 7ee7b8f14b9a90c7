## A pneumatic cylinder positioned by a PID controller in a computer: what the motion needs of the
## valves, how the controller follows with and without that command, what sampling and delay do,
## what the thermal models of the gas are worth; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## inputs at samples T apart: place as planned, areas beside the controller's, held (a row for each
## sample)
function p = inputs (t, place, bias)
  a = gsmbp_plan ("table", t, place(:), 3);
  coefs = zeros (3, numel (t) - 1, 4);
  coefs(1,:,:) = a.coefs;
  coefs(2:3,:,4) = bias(1:end-1,:)';
  p = mkpp (t, coefs, 3);
endfunction

## the same place and areas all the time but for a jump of place
function p = jump (at, duration, before, after, bias)
  p = mkpp ([0, at, duration], [before, after; bias(1), bias(1); bias(2), bias(2)], 3);
endfunction

## areas of the inverse model in the middle of each sample
function bias = held (m, plan, t)
  middle = (t(1:end-1) + t(2:end)) / 2;
  bias = gsmbp_inverse (m, plan, [middle; t(end)]).v;
endfunction

## least time of some runs [s], for one second of motion
function s = seconds_of (m, x0, times, varargin)
  s = Inf;
  for k = 1:3
    s = min (s, gsmbp_simulate (m, x0, times, varargin{:}).stats.seconds / times(end));
  endfor
endfunction

## Rate [1/s] of the oscillation (above 30 rad/s) that dies away most slowly, or grows (> 0):
## eigenvalues of the loop from sample to sample, the axis linearized (A, B; the first state is the
## position) and sampled exactly, the controller without converters, its output one delay behind.
function r = growth (A, B, p)
  T = p.period;
  n = rows (A);
  part = @(h) expm ([A, B; zeros(1, n + 1)] * h);   # state and area of a valve held for h
  late = part (p.late);
  soon = part (T - p.late);
  Phi = soon(1:n,1:n) * late(1:n,1:n);
  G0 = soon(1:n,end);
  G1 = soon(1:n,1:n) * late(1:n,end);
  e = [-1, zeros(1, n + 3)];                        # x, I, d, error before, output before
  at = eye (n + 4);
  d = (p.tf * at(n+2,:) + p.kd * (e - at(n+3,:))) / (p.tf + T);
  u = p.kp * e + at(n+1,:) + d;
  step = [[Phi, zeros(n, 3), G1] + G0 * u; at(n+1,:) + p.ki * T * e; d; e; u];
  z = eig (step);
  r = max (log (abs (z(arg (z) > 30 * T)))) / T;
endfunction

## the axis with another variant of its cylinder, derived and compiled in out/
function m = variant (name)
  text = strrep (fileread ("pneumatic_axis.mac"), "pneumatic_axis\"", ["axis_" name "\""]);
  file = fullfile ("out", ["axis_" name ".mac"]);
  fid = fopen (file, "w");
  fputs (fid, strrep (text, "joint = rail, pm", ["joint = rail, variant = " name ", pm"]));
  fclose (fid);
  gsmbp_derive (file, "out");
  m = gsmbp_build (["axis_" name], "directory", "out");
endfunction

## frequency of the slide on the gas [rad/s]: of the model without friction and leaks, and of
## exponent AL by the stiffness of both chambers
function [found, wanted] = frequency (m, x, al)
  p = m.par;
  free = gsmbp_set (m, "fc", 1e-9, "fs", 1e-9, "fv", 1e-9, "C_bv", 1e-9, "C_eps", 1e-14);
  found = max (abs (imag (eig (free.jac (0, x, [0; 0])))));
  pressure = x([3, numel(x)/2 + 2]);   # p1, (T1,) p2, (T2)
  volume = [p.C_vd1 + p.C_a1 * x(1); p.C_vd2 + p.C_a2 * (p.C_h - x(1))];
  wanted = sqrt (al * sum (pressure .* [p.C_a1; p.C_a2] .^ 2 ./ volume) / p.mass);
endfunction

## a state of the full model as one of variant K: the others have no temperatures
function x = states_of (x, k)
  if (k > 1)
    x = x([1 2 3 5]);
  endif
endfunction

## --------------------------------------------------------------- the models
printf ("derivation: %.1f s of processor time, Maxima's start included\n\n", ...
        gsmbp_derive ("pneumatic_position.mac"));
m = gsmbp_build ("pneumatic_position");
gsmbp_derive ("pneumatic_axis.mac", "out");
axis_ = gsmbp_build ("pneumatic_axis", "directory", "out");
accuracy = {"rtol", 1e-9};
watched = [accuracy, {"audit", 1}];
area = find (strcmp (m.outputs, "valve"));

## ------------------------------------------------- what the motion needs
plan = gsmbp_plan ("septic", [0.02 0.06 0.06 0.02 0.02], [0 0.4 0.8 1.2 1.8]);
t = (0:1800)' / 1000;
need = gsmbp_inverse (axis_, plan, t);
x0 = need.x(1,:)';
rest = need.v(1,:);
printf (["40 mm in 0.4 s: up to %.3f m/s; pressures %.2f to %.2f bar (cap side), %.2f to %.2f " ...
         "bar (rod side), supply %.0f bar; temperatures %.1f to %.1f K\n"], max (abs (need.u)), ...
        [min(need.x(:,[3 5])); ...
         max(need.x(:,[3 5]))] / 1e5, m.par.C_ps / 1e5, min (min (need.x(:, ...
                [4 6]))), max (max (need.x(:,[4 6]))));
printf (["valves within %.2f mm^2 (supply) and %.2f mm^2 (exhaust); margins kept: " "%s\n"], ...
        1e6 * max (need.v(:)), -1e6 * min (need.v(:)), ...
        {"no", "yes"}{1 + isempty (need.violations)});
gsmbp_plot ("out/command.png", t, panel (1e3 * need.q, {"slide"}, ...
    "position [mm]"), panel (need.x(:,[3 5]) / 1e5, {"cap side", "rod side"}, "pressure [bar]"), ...
            panel (need.x(:,[4 6]), {"cap side", "rod side"}, "temperature [K]"), panel (1e6 ...
                  * need.v, {"cap side", "rod side"}, "valve area [mm^2]"), ...
            "title", "What the motion needs");
puts ("open loop, the command computed at every call:\n");
printf ("%12s %22s %14s %12s %18s\n", "tolerance", "from the plan [m]", "audit", "ms for 1 s", ...
        "real time / run");
coarse = 1:100:numel (t);
for tolerance = [1e-8 1e-10 1e-12]
  back = gsmbp_simulate (axis_, x0, t(coarse), "motion", plan, "method", "auto", "rtol", ...
                         tolerance, "audit", 1);
  spent = seconds_of (axis_, x0, t(coarse), "motion", plan, "method", "auto", "rtol", tolerance);
  printf ("%12.0e %22.1e %14.1e %12.2f %18.0f\n", tolerance, ...
          max (abs (back.x(:,1) - need.q(coarse))), back.audit.error, 1e3 * spent, 1 / spent);
endfor
worst = back.audit.error;

## --------------------------------------------------- following the plan
## Controller alone: the valves stand at what holds the slide at its start. Command of the inverse
## model: held from sample to sample. The slide as planned, or heavier and with more friction than
## the command knows
slides = {{"mass", 1}, {"mass", 1.5, "fc", 1.4, "fs", 2.1, "fv", 26}};
still = repmat (rest, numel (t), 1);
command = held (axis_, plan, t);
off = {"kp", 1e-20, "ki", 0, "kd", 0};   # a proportional gain must be above 0
cases = {"controller alone", {}, still; "command alone", off, command; "both", {}, command};
printf ("\nfollowing the plan, sampled each %g ms, %g ms late\n", 1e3 * [m.par.period, m.par.late]);
printf ("%-18s %22s %16s %22s %16s %12s %18s\n", "", "as planned: error [mm]", "at 1.8 s [mm]", ...
        "heavier: error [mm]", "at 1.8 s [mm]", "ms for 1 s", "real time / run");
for k = 1:3
  for load = 1:2
    plant = gsmbp_set (m, cases{k,2}{:}, slides{load}{:});
    in = inputs (t, need.q, cases{k,3});
    y{k,load} = gsmbp_simulate (plant, x0, t, "input", in, watched{:});
    away{k,load} = 1e3 * (y{k,load}.x(:,1) - need.q);
    worst = max (worst, y{k,load}.audit.error);
  endfor
  spent = seconds_of (plant, x0, [0 1.8], "input", in, accuracy{:});
  printf ("%-18s %22.4f %16.4f %22.4f %16.4f %12.2f %18.0f\n", cases{k,1}, ...
          max (abs (away{k,1})), away{k,1}(end), max (abs (away{k,2})), away{k,2}(end), ...
          1e3 * spent, 1 / spent);
endfor
gsmbp_plot ("out/following.png", t, panel (1e3 * [need.q, y{1,1}.x(:,1), y{1,2}.x(:,1)], ...
    {"plan", "alone", "alone, heavier"}, "position [mm]"), ...
            panel ([away{1,1}, away{1,2}, away{3,2}], ...
                   {"alone", "alone, heavier", "both, heavier"}, "error [mm]"), ...
            panel (y{1,1}.x(:,[3 5]) / 1e5, {"cap side", "rod side"}, ...
                   "pressure [bar]"), ...
            panel (1e6 * y{1,1}.y(:,area), {"alone"}, "valve area [mm^2]"), ...
            "title", "Controller alone, and command and controller");
gsmbp_plot ("out/accuracy.png", t, panel (1e3 * [away{2,1}, away{3,1}], ...
    {"command alone", "both"}, "error [um]"), ...
            panel (1e6 * y{3,1}.y(:,area), {"controller"}, ...
                   "valve area [mm^2]"), ...
            "title", ["The slide as planned: command alone, and both; " ...
                                              "what the controller adds"]);

## ------------------------------------------------------ sampling and delay
smooth = gsmbp_set (axis_, "fc", 1e-9, "fs", 1e-9);   # no dry friction
[A, B] = smooth.jac (0, x0, rest);
pole = eig (A);
pole = pole(imag (pole) > 30);
ref = 0.02 + 0.01 * (t >= 0.1);
printf (["\nsampling and delay: slowest oscillation of the linearized loop without " ...
         "dry friction (> 0: it grows), following the plan, a step of 10 mm\n"]);
printf ("(without control: %.1f 1/s, %.1f rad/s)\n", real (pole), imag (pole));
printf ("%12s %12s %12s %22s %22s %18s %18s\n", "period [ms]", "late [ms]", "rate [1/s]", ...
        "alone: error [mm]", "both: error [mm]", "step: over [mm]", "swings by [mm]");
settings = [1 0.2; 1 1; 2 0.2; 2 2; 5 0.2; 5 5];
for k = 1:rows (settings)
  s = gsmbp_set (m, "period", settings(k,1) / 1e3, "late", settings(k,2) / 1e3);
  ts = (0:settings(k,1):1800)' / 1000;
  place = gsmbp_evaluate (plan, ts)';
  alone = gsmbp_simulate (s, x0, t, "input", inputs (ts, place, repmat (rest, numel (ts), 1)), ...
                          watched{:});
  if (settings(k,1) > 1 && settings(k,1) != settings(k-1,1))
    command = held (axis_, plan, ts);
  endif
  both = gsmbp_simulate (s, x0, t, "input", inputs (ts, place, command), watched{:});
  hop{k} = gsmbp_simulate (s, x0, t, "input", jump (0.1, 1.8, 0.02, 0.03, rest), watched{:});
  worst = max ([worst, alone.audit.error, both.audit.error, hop{k}.audit.error]);
  swing = 1e3 * range (hop{k}.x(t > 1.5,1));
  lost{k} = 1e3 * (alone.x(:,1) - need.q);
  printf ("%12g %12g %12.2f %22.4f %22.4f %18.3f %18.3f\n", settings(k,:), growth (A, ...
      B(:,1) - B(:,2), s.par), max (abs (lost{k})), ...
          1e3 * max (abs (both.x(:,1) - need.q)), 1e3 * max (hop{k}.x(:,1) - ref), swing);
endfor
few = t <= 0.8;
gsmbp_plot ("out/step.png", t(few), panel (1e3 ...
      * [ref, hop{1}.x(:,1), hop{4}.x(:,1), hop{6}.x(:,1)](few,:), ...
    {"reference", "1 ms, 0.2 ms late", "2 ms, 2 ms late", "5 ms, 5 ms late"}, "position [mm]"), ...
            panel (1e6 * [hop{1}.y(:,area), hop{6}.y(:,area)](few,:), ...
                   {"1 ms, 0.2 ms late", "5 ms, 5 ms late"}, "valve area [mm^2]"), ...
            panel (hop{1}.x(few,[3 5]) / 1e5, {"cap side, 1 ms", "rod side, 1 ms"}, ...
                   "pressure [bar]"), "title", "A step of 10 mm: sampling and delay");
gsmbp_plot ("out/sampling.png", t, panel ([lost{1}, lost{3}, lost{5}], ...
    {"1 ms, 0.2 ms late", "2 ms, 0.2 ms late", "5 ms, 0.2 ms late"}, "error [mm]"), ...
            panel ([lost{2}, lost{4}, lost{6}], ...
                   {"1 ms, a period late", "2 ms, a period late", "5 ms, a period late"}, ...
                   "error [mm]"), "title", ...
                       "Controller alone, following the plan: sampling and delay");

## ------------------------------------------------------ models of the gas
## each under the command that the full model needs, for a fast and a slow motion; Fs = Fc, or slow
## motions would stick and slip in open loop
puts (["\nmodels of the gas; estimates for the fast motion (40 mm in 0.4 s), for " ...
       "the slow one (40 mm in 12 s)\n"]);
choice ("pneumatic_axis.mac", "0.01, [omega_c = 17.5, amplitude = 0.04]");
puts ("\n");
choice ("pneumatic_axis.mac", "0.01, [omega_c = 0.58, amplitude = 0.04]");
durations = [0.4 12];
names = {"full", "polytropic", "isothermal", "adiabatic"};
exponents = [NaN, 1.2, 1, 1.4];
plain = gsmbp_set (axis_, "fs", axis_.par.fc);
for k = 1:4
  v{k} = plain;
  if (k > 1)
    v{k} = gsmbp_set (variant (names{k}), "fs", axis_.par.fc);
  endif
  [found(k), wanted(k)] = frequency (v{k}, states_of (x0, k), exponents(k));
endfor
warning ("off", "gsmbp:stiff");      # smoothed friction; explicit steps keep the energy better here
for d = 1:2
  move = gsmbp_plan ("septic", [0.02 0.06], [0 durations(d)]);
  td = linspace (0, durations(d), 401)';
  needed = gsmbp_inverse (plain, move, td);
  table = gsmbp_plan ("table", td, needed.v, 3);
  for k = 1:4
    start = states_of (needed.x(1,:)', k);
    r = gsmbp_simulate (v{k}, start, td, "input", table, watched{:});
    worst = max (worst, r.audit.error);
    moved{k,d} = r.x(:,1);
    error_(k,d) = max (abs (r.x(:,1) - moved{1,d})) / 0.04;
    ms(k,d) = 1e3 * seconds_of (v{k}, start, [0 durations(d)], "input", table, accuracy{:});
  endfor
endfor
## both valves open for 50 ms: the slide goes where the gas takes it
burst = mkpp ([0 0.05 0.4], [rest + [5e-7, -5e-7]; rest]'(:), 2);
td = linspace (0, 0.4, 401)';
for k = 1:4
  r = gsmbp_simulate (v{k}, states_of (x0, k), td, "input", burst, watched{:});
  worst = max (worst, r.audit.error);
  thrown{k} = r.x(:,1);
  error_(k,3) = max (abs (thrown{k} - thrown{1})) / range (thrown{1});
endfor
p = axis_.par;
## at 4 bar, in the middle
warm = 4e5 * (p.C_vd1 + p.C_a1 * p.C_h / 2) / ((p.C_k - 1) * p.C_t0 * p.C_ha);
estimates = @(w) [0; (p.C_k - 1) / (2 * p.C_k); (p.C_k - 1) / 2 * w * warm; ...
                  (p.C_k - 1) / (2 * p.C_k) * (1 + 1 / (w * warm))];
expected = [estimates(17.5), estimates(0.58), estimates(94)];
printf ("\nthe gas takes the temperature of the walls within %.2f s\n", warm);
printf ("largest difference from the full model, part of the stroke (in brackets: estimate)\n");
printf ("%-12s %18s %18s %20s %20s %20s %12s\n", "variant", "slide on gas", "by stiffness", ...
        "40 mm in 0.4 s", "40 mm in 12 s", "valves open 50 ms", "ms for 1 s");
for k = 1:4
  stiffness = "-";
  if (k > 1)
    stiffness = sprintf ("%.3f rad/s", wanted(k));
  endif
  printf (["%-12s %12.3f rad/s %18s %10.4f (%7.4f) %10.4f (%7.4f) %10.4f (%7.4f) " "%12.2f\n"], ...
          names{k}, found(k), stiffness, [error_(k,:); expected(k,:)], ms(k,1));
endfor
gsmbp_plot ("out/variants.png", linspace (0, 1, 401)', panel (1e3 * [moved{:,1}], ...
    strcat (names, {" in 0.4 s"}), "position [mm]"), ...
            panel (1e3 * ([moved{2:4,1}] - moved{1,1}), strcat (names(2:4), {" in 0.4 s"}), ...
                   "difference [mm]"), ...
            panel (1e3 * ([moved{2:4,2}] - moved{1,2}), strcat (names(2:4), {" in 12 s"}), ...
                   "difference [mm]"), ...
            panel (1e3 * [thrown{:}], strcat (names, {", valves open"}), ...
                   "position [mm]"), "xlabel", "time / duration", "head", "part", ...
                       "title", "Models of the gas under the same command");

printf (["\nenergy audits of all runs: not found %.1e of what passed, at most (%.2f " ...
         "J passed while the controller followed the plan)\n\n"], worst, ...
        y{1,1}.audit.passed(end));
at = gsmbp_inverse (axis_, plan, 0.2);
gsmbp_timing (axis_, 0.2, at.x', "input", at.v, "qj", at.qj, "seconds", 0.05);
diary off

## ------------------------------------------------------ what it looks like
## chambers coloured by their pressure: the darker, the higher
r = y{1,1};
frames = titles = {};
box = @(x, h) [x(1), x(2), x(2), x(1), x(1); -h, -h, h, h, -h; 0 0 0 0 0];
shade = @(p) sprintf ("filledcurves closed fc rgb '#%02x%02xff'", ...
                      round (255 * (1 - 0.8 * (p - 3.5e5) / 1e5)) * [1 1]);
for k = 1:25:numel (t)
  s = r.x(k,1);
  frames{end+1} = {box([0, s], 0.0095), shade(r.x(k,3)), ""; box([s, 0.0762], ...
      0.0095), shade(r.x(k,5)), ""; box([0, 0.0762], 0.0095), "lines lw 2 lc rgb 'black'", ""; ...
                   box(s + [-0.002, 0.002], ...
                       0.0095), "filledcurves closed fc rgb '#666666'", ""; [s, s + 0.09; 0 0; ...
                       0 0], "lines lw 5 lc rgb '#666666'", "piston and rod"; ...
                   box(s + [0.09, 0.12], ...
                       0.014), "lines lw 3 lc rgb '#c0392b'", "slide"; [need.q(k) ...
                         + [0.105, 0.105]; 0.016, 0.024; 0, ...
                       0], "lines lw 3 lc rgb '#2a8f5a'", "plan"; ...
                   [0, 0.2; -0.014, -0.014; 0 0], "lines lw 1 lc rgb '#888888'", ""};
  titles{end+1} = sprintf ("t = %5.3f s", t(k));
endfor
film ("out/motion.gif", frames, "view", [0 90], "titles", titles, "fps", 20, "width", 560);
film ("out/cylinder.png", frames(9), "view", [0 90], "titles", titles(9), "width", 560);
