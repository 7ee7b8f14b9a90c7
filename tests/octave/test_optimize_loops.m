## gsmbp_optimize on closed chains: known optima of static balance, efforts along a motion.

function test_optimize_loops ()
  if (! gsmbp_has_nlopt () || ! gsmbp_has_ipopt ())
    printf ("ok left out: libnlopt-dev or coinor-libipopt-dev is not installed\n");
    return;
  end
  m = gsmbp_fixture ("design_linkage");
  weights (gsmbp_set (m, "k", 0));
  parallelogram (m);
  along_a_plan (m);
  masses (m);
  cognates (gsmbp_fixture ("design_fourbar"));
end

function near (what, found, expected, tolerance)
  off = max (abs (found - expected) ./ abs (expected));
  gsmbp_check (sprintf ("%s, found %.2g off", what, off), off < tolerance);
end

## a four-bar balanced by two counterweights (Berkof and Lowen 1969): its centre stands still
function weights (m)
  p = m.par;
  still = {"positions", "q1", (0.6:1:6)'};
  r = gsmbp_optimize (m, {"r1", 0.05, [0 1]; "r3", 0.1, [0 1]}, {"square", "effort.q1"}, {}, still);
  known = [p.m1 * p.s1 + p.m2 * (1 - p.e) * p.a, p.m3 * p.s3 + p.m2 * p.e * p.c];
  near ("a four-bar is balanced by counterweights", [r.values.r1, r.values.r3], known, 1e-6);
  gsmbp_check (["with exact derivatives: " r.derivatives], r.solved ...
               && strcmp (r.derivatives, "exact"));
  x = gsmbp_assemble (r.model, [0.6 0.1 1.4 0 0 0], "hold", "q1");
  run = gsmbp_simulate (r.model, x, 0:0.1:0.5, "input", 0.5);
  whole = (p.m1 + p.m2 + p.m3 + p.w1 + p.w3) * 9.81;
  f = @(name) run.of.(["at_a." name]) + run.of.(["at_d." name]);
  shake = max (abs ([f("x"); f("y") - whole])) / max (abs (run.of.("at_a.x")));
  gsmbp_check (sprintf ("it shakes nothing while it runs, found %.2g", shake), shake < 1e-5);
end

## a parallelogram with a load on its coupler, balanced by a spring without a free length
function parallelogram (m)
  m = gsmbp_set (m, "d", 0.3, "c", 0.1, "s3", 0.04, "w1", 0, "w3", 0);
  p = m.par;
  known = 9.81 * (p.m1 * p.s1 + p.m2 * p.a + p.m3 * p.s3) / (p.h * p.r);
  guess = {"guess", [0.5; -0.5; 0.5]};
  for goal = {"square", "peak"}
    r = gsmbp_optimize (m, {"k", 20, [1 1e4]}, {goal{1}, "effort.q1"}, {}, ...
                        [{"positions", "q1", [0.5; 0.9; 1.3]}, guess]);
    near (["a parallelogram is balanced by a spring, by " goal{1}], r.values.k, known, 1e-6);
  end
end

## the weight of least mean square effort along a motion (the efforts are linear in it: least
## squares); a free amplitude; a peak
function along_a_plan (m)
  t = linspace (0, 1, 21);
  at = @(w) gsmbp_inverse (gsmbp_set (m, "w1", w), gsmbp_plan ("quintic", [0.6 2.6], [0 1]), t).tau;
  plan = gsmbp_plan ("quintic", [0.6 2.6], [0 1]);
  r = gsmbp_optimize (m, {"w1", 1, [0 50]}, {"square", "effort.q1"}, {}, {"inverse", plan, t});
  [t0, t1] = deal (at (0), at (1) - at (0));
  w = r.results.case1.w(:);
  near ("the weight of least effort along a motion", r.values.w1, ...
        -(t1' * (w .* t0)) / (t1' * (w .* t1)), 1e-6);
  gsmbp_check ("with exact derivatives", strcmp (r.derivatives, "exact"));
  go = @(p) gsmbp_plan ("quintic", [0.6 0.6 + p.s], [0 1]);
  [r, info] = gsmbp_optimize (m, {"s", 0.5, [0.1 3]}, {"end", "q1", -1}, ...
                              {"peak", "effort.q1", "<", 1.5}, {"inverse", go, t});
  most = max (abs (gsmbp_inverse (m, go (r.values), t).tau));
  gsmbp_check (sprintf ("the longest way with a bounded torque, %.9g of 1.5", most), info == 0 ...
               && abs (most - 1.5) < 1e-6 && strcmp (r.derivatives, "exact"));
end

## the lightest weights that balance: the longest arms; of a rod of given density the longest one
function masses (m)
  still = {"positions", "q1", (0.6:1:6)'};
  m = gsmbp_set (m, "k", 0);
  free = {"w1", 1, [0 20]; "r1", 0.05, [0.01 0.08]; "w3", 1, [0 20]; "r3", 0.1, [0.01 0.3]};
  r = gsmbp_optimize (m, free, {"mass", "front, back"}, {"each", "effort.q1", "=", 0}, still);
  p = m.par;
  known = [(p.m1*p.s1 + p.m2*(1 - p.e)*p.a) / 0.08, (p.m3*p.s3 + p.m2*p.e*p.c) / 0.3];
  near ("the lightest weights that balance", [r.values.w1, r.values.w3, r.J], ...
        [known, sum(known)], 1e-6);
  crank = gsmbp_fixture ("sensitivity_crank");
  p = crank.par;
  r = gsmbp_optimize (crank, {"l2", 0.5, [0.1 9]; "rho", 3, [2.5 9]}, {"value", "l2", -1}, ...
                      {"mass", "all", "<", 10});
  near ("the longest rod of a machine of 10 kg", [r.values.l2, r.values.rho], ...
        [(10 - p.m1 - p.m3) / 2.5, 2.5], 1e-6);
  k = strncmp ({r.active.text}, "mass all < 10", 13);
  near ("one more kilogram makes it longer by 1/rho", r.active(k).multiplier, 1 / 2.5, 1e-5);
  text = gsmbp_complaint (@() gsmbp_optimize (crank, {"rho", 3, [1 9]}, {"mass", "rods"}));
  gsmbp_check (["refused: " text], ! isempty (strfind (text, ...
               'mass: unknown link "rods", did you mean "rod"')));
end

## an untimed path of twelve places has three optima, Roberts' cognates, one from each start: the
## angles between crank and coupler are unknown as well
function cognates (m)
  th = 0.4 + (0:11)' * pi / 6;
  [known, P] = roberts (m.par, th);
  target = struct ("px", real (P), "py", imag (P));
  angles = arrayfun (@(k) sprintf ("t%d", k), 1:12, "UniformOutput", false);
  names = [{"xa", "ya", "a", "b", "c", "dx", "dy", "cx", "cy"}, angles];
  made = cell2mat (cellfun (@(k) [cellfun(@(n) k.(n), names(1:9)), k.q(:,2)'], known', ...
                            "UniformOutput", false));
  rand ("state", 3);
  start = made + 0.01 * (2 * rand (size (made)) - 1);
  free = [names', num2cell(start(1,:)'), repmat({[-9 9]}, 21, 1)];
  near_by = @(p) known{nearest ([p.a, p.b, p.c], made(:,3:5))}.q(1,:)';
  path = {"positions", "q2", @(p) cellfun(@(n) p.(n), angles)', "guess", near_by, "target", target};
  r = gsmbp_optimize (m, free, {"square", "error.px"; "square", "error.py"}, {}, path, ...
                      "starts", start(2:3,:), "evaluations", 100);
  for k = 1:3
    found = cellfun (@(n) r.starts(k).values.(n), names);
    off = max (abs (found - made(k,:)));
    gsmbp_check (sprintf ("cognate %d is an optimum, found %.2g off, %.2g missed", k, off, ...
                          sqrt (r.starts(k).J)), off < 1e-6 && r.starts(k).J < 1e-16);
  end
  gsmbp_check ("with exact derivatives", strcmp (r.derivatives, "exact"));
  text = gsmbp_complaint (@() gsmbp_optimize (m, free, {"square", "error.px"}, {}, path, ...
                                              "starts", [1 2 3]));
  gsmbp_check (["refused: " strtok(text, "(")], ! isempty (strfind (text, "found 3 columns")));
end

function k = nearest (x, rows_)
  [~, k] = min (sum ((rows_ - x) .^ 2, 2));
end

## by complex numbers (Roberts 1875): crank, coupler, rocker r2, r3, r4, the point at k*r3
function [list, P] = roberts (p, th)
  g = p.dx + 1i * p.dy;
  k = (p.cx + 1i * p.cy) / p.b;
  [A0, r2] = deal (p.xa + 1i * p.ya, p.a * exp (1i * th));
  v = g - r2;   # r3 - r4
  r3 = p.b * v ./ abs (v) .* exp (1i * acos ((abs (v) .^ 2 + p.b ^ 2 - p.c ^ 2) ...
                                             ./ (2 * abs (v) * p.b)));
  r4 = r3 - v;
  P = A0 + r2 + k * r3;
  list = {four_bar(A0, r2, r3, r4, g, p.b * k), ...
          four_bar(A0, k * r3, k * r2, k * r4, k * g, abs (k * p.a) / k), ...
          four_bar(A0 + k * g, (1 - k) * r2, (k - 1) * r4, (k - 1) * r3, (1 - k) * g, ...
                   abs (1 - k) * p.c * k / (k - 1))};
end

function f = four_bar (pivot, crank, coupler, rocker, ground, place)
  f = struct ("xa", real (pivot), "ya", imag (pivot), "a", abs (crank(1)), "b", ...
              abs (coupler(1)), "c", abs (rocker(1)), "dx", real (ground), "dy", imag (ground), ...
              "cx", real (place), "cy", imag (place), "q", ...
              [unwrap(angle (crank)), unwrap(angle (coupler ./ crank)), unwrap(angle (rocker))]);
end
