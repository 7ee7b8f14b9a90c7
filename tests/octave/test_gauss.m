## Collocation of Gauss: its orders, the energy of long free runs, loops, inputs, failures.

function test_gauss ()
  m = gsmbp_fixture ("gauss_arms");
  orders (m);
  energy (m);
  turning (m, gsmbp_fixture ("gauss_bars"));
  turned_back (gsmbp_fixture ("gauss_wheel"));
  in_space (gsmbp_fixture ("gauss_space"));
  told (gsmbp_fixture ("gauss_bars"), gsmbp_fixture ("gauss_told"));
  crank (gsmbp_hand ("hand_crank"));
  inputs (gsmbp_hand ("motor_pendulum"));
  sampled (gsmbp_fixture ("sampled_crank"));
  failures (m, gsmbp_hand ("motor_pendulum"));
end

function varargout = gauss (m, x0, t, varargin)
  [varargout{1:nargout}] = gsmbp_simulate (m, x0, t, "method", "gauss", varargin{:});
end

## half the step: 2^order of the error
function orders (m)
  x0 = [-1; 0.3; 0; 0];
  exact = gsmbp_simulate (m, x0, [0 1], "rtol", 1e-14).x(2,:);
  for order = [4 6 8]
    h = 0.04;
    e = arrayfun (@(h) norm (gauss (m, x0, [0 1], "maxorder", order, "step", h).x(2,:) - exact), ...
                  [h, h/2]);
    gsmbp_check (sprintf ("order %d, found %.2f (error %.2g)", order, log2 (e(1) / e(2)), e(2)), ...
                 abs (log2 (e(1) / e(2)) - order) < 0.4);
  end
  r = gauss (m, x0, [0 0.013 1]);
  gsmbp_check ("whole steps to every output time", r.stats.accepted == 13 + 987 ...
               && abs (r.stats.largest_step - 1e-3) < 1e-15);
end

## 4e4 steps: the energy stays where it is, that of dp853 at the same cost does not
function energy (m)
  x0 = [-1; 0.3; 0; 0];
  t = 0:10:100;
  r = gauss (m, x0, t, "step", 2.5e-3);
  gsmbp_check (sprintf ("energy of 40000 steps, found %.2g", swing (m, r)), swing (m, r) < 1e-13);
  other = gsmbp_simulate (m, x0, t, "rtol", 1e-8);
  gsmbp_check (sprintf ("dp853 at 1e-8: %.2g", swing (m, other)), swing (m, other) > 1e-10);
end

function e = energies (m, r)
  E = arrayfun (@(k) sum (m.ene (r.t(k), r.x(k,:)')(1:2)), 1:numel (r.t));
  e = (E - E(1)) / abs (E(1));
end

function e = swing (m, r)
  e = max (abs (energies (m, r)));
end

## what turns on in one direction: the energy goes up and down within a turn, no more in the last
## tenth of the run than in the first, and comes back; the loop stays closed
function turning (arms, bars)
  x0 = gsmbp_assemble (bars, [1 -0.1 1.4 10 0 0], "hold", "q1");
  for one = {"arms", arms, [-1; 0.3; 40; -3], 3e-12, 5e-13
             "bars", bars, x0, 3e-10, 1e-12}'
    [name, m, start, most, mean_most] = one{:};
    r = gauss (m, start, 0:0.01:40, "step", {1e-3, 2e-3}{1 + strcmp(name, "bars")});
    e = energies (m, r);
    first = e(1:400);
    last = e(end-399:end);
    what = sprintf (["%s that turn over %.0f rad: the energy at most off by %.2g, at last " ...
                     "%.2g, "], name, r.x(end,1), max (abs (first)), max (abs (last)));
    gsmbp_check (sprintf ("%sin the mean %.2g, %.2g", what, mean (first), mean (last)), ...
                 r.x(end,1) > 300 && max (abs (e)) < most ...
                 && max (abs (last)) < 1.2 * max (abs (first)) ...
                 && abs (mean (last) - mean (first)) < mean_most);
  end
  gsmbp_check (sprintf ("their loop: %.2g, %.2g", r.stats.drift.phi, r.stats.drift.phidot), ...
               r.stats.drift.phi < 2e-15 && r.stats.drift.phidot < 1e-14);
end

## a stop 16 turns away is met although turns are kept apart
function turned_back (m)
  t = 0:1:24;
  exact = gsmbp_simulate (m, [0; 15], t, "method", "radau", "rtol", 1e-11).x;
  r = gauss (m, [0; 15], t, "step", 5e-4);
  e = max (abs (r.x - exact)(:));
  gsmbp_check (sprintf ("a stop far away, found %.2g, farthest %.0f, %.0f", e, max (r.x(:,1)), ...
                        min (r.x(:,1))), ...
               e < 1e-3 && max (r.x(:,1)) > 80 && min (r.x(:,1)) < -80);
end

## events that only tell, some a turn, leave the motion of a loop as it is without them
function told (bars, m)
  x0 = gsmbp_assemble (bars, [1 -0.1 1.4 10 0 0], "hold", "q1");
  t = 0:0.25:2;
  exact = gsmbp_simulate (bars, x0, t, "rtol", 1e-13);
  for order = [4 6 8]
    options = {"step", 1e-3, "maxorder", order};
    alone = gauss (bars, x0, t, options{:});
    r = gauss (m, x0, t, options{:});
    e = max (abs (energies (m, r)));
    [gap, most] = deal (state_gap (r, exact), state_gap (alone, exact));
    many = numel (r.events.t);
    what = sprintf ("order %d, a loop with %d events that tell: energy %.2g, ", order, many, e);
    gsmbp_check (sprintf ("%s%.2g beside dp853 (%.2g without events)", what, gap, most), ...
                 many >= 10 && r.stats.accepted == alone.stats.accepted ...
                 && e < 2 * max (abs (energies (bars, alone))) + 1e-13 ...
                 && gap < most + 1e-9 && state_gap (r, alone) < 1e-10);
  end
end

## Euler parameters: steps of the default length come to their end, as accurate as their order
function in_space (m)
  x0 = gsmbp_assemble (m, m.initial, "hold", "q1");
  x0(strcmp (m.states, "q1_d")) = 8;
  x0 = gsmbp_assemble (m, x0, "hold", "q1");
  exact = gsmbp_simulate (m, x0, [0 1 2], "rtol", 1e-12);
  [coarse, fine] = deal (gauss (m, x0, [0 1 2]), gauss (m, x0, [0 1 2], "step", 2.5e-4));
  gsmbp_check (sprintf ("a loop in space: found %.2g, %.2g", state_gap (coarse, exact), ...
                        state_gap (fine, exact)), ...
               state_gap (coarse, exact) < 1e-7 && state_gap (fine, exact) < 1e-8);
end

function crank (m)
  x0 = gsmbp_assemble (m, [0.3 -0.1 0.7 12 0 0]);
  exact = gsmbp_simulate (m, x0, [0 0.5 1], "rtol", 1e-13);
  for way = {"", "projection", "baumgarte"}
    r = gauss (m, x0, [0 0.5 1], "loops", way{1});
    gsmbp_check (sprintf ("a loop, \"%s\": found %.2g, phi %.2g", way{1}, state_gap (r, exact), ...
                          r.stats.drift.phi), state_gap (r, exact) < 1e-8);
  end
  r = gauss (m, x0, [0 1]);
  gsmbp_check ("the loops stay closed", r.stats.drift.phi < 1e-14 && r.stats.drift.phidot < 1e-13);
end

function inputs (m)
  table = gsmbp_plan ("table", [0 0.3331 1], [0 5 -2], 0);
  for given = {{"input", table}, {"input", @(t, x) 3 * sin(5 * t)}, ...
               {"gain", [40 3 0.1], "reference", [0.5; 0; 0]}}
    r = gauss (m, [0.1; 0; 0], 0:0.25:1, "step", 5e-3, "maxorder", 8, given{1}{:});
    e = state_gap (r, gsmbp_simulate (m, [0.1; 0; 0], 0:0.25:1, "rtol", 1e-13, given{1}{:}));
    gsmbp_check (sprintf ("inputs, found %.2g", e), e < 1e-9);
  end
end

## a drive that gives nothing at the start, whose effort is in no bias force of the tree; rows at
## and just behind samples
function sampled (m)
  t = [0, 0.1, 0.3 * (1 + eps), 0.4, 0.5];
  exact = gsmbp_simulate (m, zeros (6, 1), t, "rtol", 1e-12);
  for loops = {"partitioning", "projection"}
    r = gauss (m, zeros (6, 1), t, "loops", loops{1});
    e = max (max (abs (r.x - exact.x)) ./ max (abs (exact.x)));
    gsmbp_check (sprintf ("samples, %s, found %.2g", loops{1}, e), e < 1e-8);
  end
end

function failures (m, motor)
  says = @(f, text) gsmbp_check (["refused: " text], ...
                                 any (strfind (gsmbp_complaint (f), text)));
  says (@() gauss (m, [0 0 0 0], [0 1], "step", 0), ...
        "option step: expected a finite number above 0");
  says (@() gauss (m, [0 0 0 0], [0 1], "maxorder", 5), "expected one of 4, 6, 8, found 5");
  stiff = gsmbp_set (motor, "L_a", 1e-6);
  says (@() gauss (stiff, [0.2; 0; 0], [0 1], "input", 3, "step", 0.01), ...
        "the iteration does not end: take a shorter step");
end
