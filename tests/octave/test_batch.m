## The routines for many states at once (INV_V, MAS_V, BIA_V, FWD_V, RHS_V): against those for one
## state and against the quad-precision build, batches of every kind of size, large angles, states
## that are no numbers, events.

function test_batch ()
  rand ("twister", 11);
  for name = {"batch_arm", "batch_bars", "batch_stop", "event_crank", "event_strut", ...
              "trim_integral"}
    m = gsmbp_fixture (name{1});
    sizes (name{1}, m);
    bad_states (name{1}, m);
  end
  for name = {"batch_arm", "batch_bars"}
    rounding (name{1}, gsmbp_fixture (name{1}), gsmbp_fixture (name{1}, "precision", "quad"));
  end
  large_angles (gsmbp_fixture ("batch_arm"));
  singular (gsmbp_fixture ("batch_bead"));
  lost_rank (gsmbp_fixture ("batch_bars", "parameters", struct ("lc", 0.25, "ld", 0.7)));
  ways (gsmbp_fixture ("batch_bars", "parameters", struct ("loop_method", 4)));
  arguments (gsmbp_fixture ("batch_arm"));
  decays (gsmbp_fixture ("batch_decay"));
end

## K states, a column each: angles of half a turn to both sides; those of a closed chain on its
## constraints
function s = states (m, K)
  d = m.sizes;
  half = @(n) 2 * rand (n, K) - 1;
  s.t = 3 * rand (1, K);
  s.q = pi * half (d.nq);
  s.u = 2 * half (d.nu);
  s.ud = 5 * half (d.nu);
  s.tau = 20 * half (d.nu);
  s.v = 3 * half (d.nv);
  modes = zeros (1, 0);
  if (! isempty (m.events))
    modes = [m.events.input];
  end
  s.v(modes,:) = randi ([-1, 1], numel (modes), K);
  s.x = [s.q; s.u; half(d.nx - d.nq - d.nu)];
  if (d.nlam > 0)
    for k = 1:K
      s.x(:, k) = m.prj (s.t(k), m.initial + 0.2 * (2 * rand (d.nx, 1) - 1));
    end
  end
end

## results of all five as batches, and of one state
function r = batches (m, s)
  r.inv = m.inv_v (s.t, s.q, s.u, s.ud, s.v);
  r.mas = reshape (m.mas_v (s.t, s.q), [], columns (s.q));
  r.bia = m.bia_v (s.t, s.q, s.u, s.v);
  [r.fwd, r.fwd_info] = m.fwd_v (s.t, s.q, s.u, s.v, s.tau);
  [r.rhs, r.rhs_info] = m.rhs_v (s.t, s.x, s.v);
end

function r = single (m, s, k)
  r.inv = m.inv (s.t(k), s.q(:, k), s.u(:, k), s.ud(:, k), s.v(:, k));
  r.mas = m.mas (s.t(k), s.q(:, k))(:);
  r.bia = m.bia (s.t(k), s.q(:, k), s.u(:, k), s.v(:, k));
  [r.fwd, r.fwd_info] = m.fwd (s.t(k), s.q(:, k), s.u(:, k), s.v(:, k), s.tau(:, k));
  [r.rhs, r.rhs_info] = m.rhs (s.t(k), s.x(:, k), s.v(:, k));
end

## the same for all states, one after the other
function r = singles (m, s)
  for k = columns (s.q):-1:1
    one = single (m, s, k);
    for [value, name] = one
      r.(name)(:, k) = value;
    end
  end
end

## largest error over the states, relative in the 2-norm of each state's result, row by row: inv,
## mas, bia, fwd, rhs
function e = distance (a, b)
  e = [];
  for name = {"inv", "mas", "bia", "fwd", "rhs"}
    [x, y] = deal (a.(name{1}), b.(name{1}));
    e(end+1, 1) = max (sqrt (sum ((x - y) .^ 2, 1)) ./ max (sqrt (sum (y .^ 2, 1)), realmin));
  end
end

## inv mas bia fwd rhs. The rounding of batch and single differs in the sines (below one unit here,
## about a half in the library) and by what the compiler contracts: some units of 1.1e-16 in a
## result of some hundred operations, more where its terms cancel. Solutions: that times the
## condition of M (the arm's is 1e4) or of the loop.
function t = tolerance ()
  t = [2e-14; 3e-15; 2e-14; 1e-12; 1e-12];
end

## batches below a block of eight, of whole blocks, and with a last block that overlaps
function sizes (name, m)
  for K = [1 7 8 9 63 64 65 1000]
    s = states (m, K);
    [a, b] = deal (batches (m, s), singles (m, s));
    gsmbp_check (sprintf ("%s: %d states at once against one by one, in tolerances", name, K), ...
                 distance (a, b) ./ tolerance (), 1);
    gsmbp_check (sprintf ("%s: indicators of %d states", name, K), ...
                 isequal (a.fwd_info, b.fwd_info) && isequal (a.rhs_info, b.rhs_info));
  end
end

## The error against quad precision is not beyond that of the routine for one state: sines good to
## 0.8 units instead of 0.55 may make it a half larger, and the worst of 1000 states is a matter of
## luck.
function rounding (name, m, exact)
  s = states (m, 1000);
  best = batches (exact, s);
  [many, one] = deal (distance (batches (m, s), best), distance (singles (m, s), best));
  printf ("   %s: inv mas bia fwd rhs, batch %s, single %s\n", name, sprintf (" %.1e", many), ...
          sprintf (" %.1e", one));
  gsmbp_check ([name ": error against quad precision over that of one state at a time"], ...
               many ./ max (one, eps), 3);
end

## Angles as they stand after many turns, up to where a unit in the last place is many turns: beyond
## 1e5 rad GSSCV leaves them to the library. Sums of angles round alike.
function large_angles (m)
  for size = [1e3 1e5 1.1e5 1e8 1e15]
    s = states (m, 64);
    s.q = s.q * size;
    s.x(1:m.sizes.nq, :) *= size;
    gsmbp_check (sprintf ("angles of %.1e rad, in tolerances", size), ...
                 distance (batches (m, s), singles (m, s)) ./ tolerance (), 1);
  end
  s = states (m, 64);
  s.q(3, 20) = 1e9;
  gsmbp_check ("one large angle among small ones, in tolerances", ...
               distance (batches (m, s), singles (m, s)) ./ tolerance (), 1);
end

## states whose mass matrix is singular, one in a whole block, one in the block that overlaps: the
## indicator of these alone
function singular (m)
  s = states (m, 21);
  s.q(2,:) += 5;
  s.x(2,:) += 5;
  s.q(2,[3, 20]) = s.x(2,[3, 20]) = 0;
  expected = double (ismember (1:21, [3, 20]));
  [a, b] = deal (batches (m, s), singles (m, s));
  gsmbp_check ("singular states: indicators of one by one", ...
               isequal (b.fwd_info, expected) && isequal (b.rhs_info, expected));
  gsmbp_check ("singular states: indicators at once", ...
               isequal (a.fwd_info, expected) && isequal (a.rhs_info, expected));
end

## a state that is no number: its own result and indicator, no other
function bad_states (name, m)
  s = states (m, 21);
  good = batches (m, s);
  s.q(:, 5) = NaN;
  s.u(end, 20) = Inf;
  s.x(:, 5) = NaN;
  s.x(end, 20) = -Inf;
  r = batches (m, s);
  others = setdiff (1:21, [5 20]);
  pick = @(r) struct ("inv", r.inv(:, others), "mas", r.mas(:, others), "bia", r.bia(:, others), ...
                      "fwd", r.fwd(:, others), "rhs", r.rhs(:, others));
  gsmbp_check ([name ": the states beside one that is no number, in tolerances"], ...
               distance (pick (r), pick (good)) ./ tolerance (), 1);
  gsmbp_check ([name ": their indicators"], ...
               all (r.fwd_info(others) == 0) ...
                 && isequal (r.rhs_info(others), good.rhs_info(others)));
  gsmbp_check ([name ": indicators of the bad states"], ...
               isequal (r.fwd_info([5 20]), [-2 -3]) && isequal (r.rhs_info([5 20]), [-2 -2]));
  gsmbp_check ([name ": results of the bad states are no numbers"], ...
               all (isnan (r.fwd(:, 5))) && all (isnan (r.rhs(:, 20))) ...
                 && any (isnan (r.inv(:, 5))));
end

## one state where the constraints lose rank: its indicator is 2, results as one by one
function lost_rank (m)
  s = states (m, 19);
  s.x(1:3, 11) = 0;
  [a, ia] = m.rhs_v (s.t, s.x, s.v);
  for k = 19:-1:1
    [b(:, k), ib(k)] = m.rhs (s.t(k), s.x(:, k), s.v(:, k));
  end
  gsmbp_check ("lost rank is told of its state alone", ...
               isequal (ia, ib) && ia(11) == 2 && sum (ia == 2) == 1);
  gsmbp_check ("results beside it", max (max (abs (a - b)) ./ max (abs (b))), 1e-10);
end

## another way of solution than the one on the tape
function ways (m)
  s = states (m, 10);
  [a, b] = deal (m.rhs_v (s.t, s.x, s.v), m.rhs (s.t(3), s.x(:, 3), s.v(:, 3)));
  gsmbp_check ("loop_method 4 is that of the routine for one state", a(:, 3) == b);
end

## one column for all states, nothing for zero, no state; what does not fit
function arguments (m)
  s = states (m, 12);
  gsmbp_check ("one time and one input for all", ...
               m.inv_v (0.5, s.q, s.u, s.ud, [2; 1]) == m.inv_v (0.5 * ones (1, 12), s.q, s.u, ...
                 s.ud, [2; 1] * ones (1, 12)));
  gsmbp_check ("no input is zero", m.bia_v (0.5, s.q, s.u) == m.bia_v (0.5, s.q, s.u, [0; 0]));
  gsmbp_check ("no state", ...
               isequal (size (m.inv_v (0, zeros (6, 0), zeros (6, 0), zeros (6, 0))), [6 0]) ...
                 && isequal (size (m.mas_v (0, zeros (6, 0))), [6 6 0]));
  gsmbp_check ("a row short is an error", ...
               ! isempty (strfind (gsmbp_complaint (@() m.inv_v (0, s.q(1:5, :), s.u, s.ud)), ...
                                   ["argument q: expected 6 rows, a column for each state, " ...
                                    "found 5x12"])));
  gsmbp_check ("a state short is an error", ...
               ! isempty (strfind (gsmbp_complaint (@() m.inv_v (0, s.q, s.u(:, 1:11), s.ud)), ...
                                   "argument u: expected 12 columns (or one for all), found 11")));
  s.q(2, 7) = NaN;
  gsmbp_check ("an indicator that is not taken is an error", ...
               ! isempty (strfind (gsmbp_complaint (@() m.fwd_v (0, s.q, s.u, [], s.tau)), ...
                                   "state 7: INFO = -2")));
  gsmbp_check ("not emitted unless asked for", ...
               ! any (strcmp (gsmbp_fixture ("case_03a").subroutines, "inv_v")));
end

## exponentials that underflow, also by infinite arguments; what is no number stays so
function decays (m)
  x = [0, -1, -700, -707.9, -708.1, -720, -760, -1e3, -1e200, -3e299, 1:6, ...
       0, 0.01, 0.05, 0.2, 0.266, 0.267, 0.3, 0.31, 0.1, -1e160, -1e299, 0.1, 0, 0, 0, 0];
  x(2,:) = 0;
  many = m.rhs_v (zeros (1, 32), x);
  one = cell2mat (arrayfun (@(k) m.rhs (0, x(:,k)), 1:32, "UniformOutput", false));
  gsmbp_check ("exponentials that underflow", (many - one) ./ (1e-290 + abs (one)), 1e-14);
  bad = gsmbp_set (m, "v", 0, "b", 0);
  gsmbp_check ("one of 0/0", ...
               isequaln (bad.rhs_v (zeros (1, 8), zeros (2, 8)), [0; NaN](:,ones (1, 8))) ...
                 && isequaln (bad.rhs (0, [0; 0]), [0; NaN]));
end
