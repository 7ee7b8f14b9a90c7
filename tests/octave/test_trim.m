## Equilibria: of machines whose states have very different sizes, of stiff ones, from far away;
## what is none is an error that says why.

function test_trim ()
  fluids ();
  stiff ();
  moving ();
  far ();
  margins ();
  flat ();
  integral ();
end

## a flat parallelogram without weight: nothing determines the force along its links
function flat ()
  m = gsmbp_set (gsmbp_fixture ("design_linkage"), "c", 0.1, "d", 0.3, "g", 0, "k", 0);
  at = @(q) [q; -q; q; 0; 0; 0];
  evalc ('r = gsmbp_trim (m, at (0), [], "hold", "q1", "free", "tau");');
  gsmbp_check ("flat: which multipliers are determined", isequal (r.unique(:)', [false true]));
  r = gsmbp_trim (m, at (0.3), [], "hold", "q1", "free", "tau");
  gsmbp_check ("... elsewhere all", all (r.unique));
end

## a cylinder out of its stroke is no equilibrium; a run that leaves the stroke, or ends there,
## names the margin
function margins ()
  m = gsmbp_fixture ("trim_hydraulic");
  out = "C: piston within its stroke, rod out";
  x = m.initial;
  x(1) = 1.5;
  said = gsmbp_complaint (@() gsmbp_trim (m, x, 0, "free", "C.u"));
  gsmbp_check ("piston 0.8 m out of its stroke: refused, with device, margin and value",
               any (strfind (said, [out ": expected above 0, found -0.8"])));
  r = gsmbp_trim (m, x, 0, "free", "C.u", "margins", "ignore");
  gsmbp_check ("... or taken as it is", r.x(1) - 1.5, 1e-12);
  [g, s] = m.mar (0, r.x, r.v);
  gsmbp_check ("m.mar: what is above 0, and its size",
               [g([5, 6]) - [1.5; -0.8]; s(6) - norm([0.7, 1.5])], 1e-12);
  said = gsmbp_complaint (@() gsmbp_simulate (m, m.initial, [0, 30], "input", 5e-4));
  gsmbp_check ("a run that ends out of the stroke: where, and which margin",
               any (strfind (said, "outside a margin: C: piston within its stroke")));
  lastwarn ("", "");
  r = gsmbp_simulate (m, m.initial, 0:0.05:0.75, "input", 5e-4, "method", "cvode", "rtol", 1e-8);
  [text, id] = lastwarn ();
  over = r.stats.margins(strcmp ({r.stats.margins.text}, out));
  first = r.t(find (r.x(:,1) > 0.7, 1));
  gsmbp_check ("a run that leaves the stroke: a warning", strcmp (id, "gsmbp:margin"));
  gsmbp_check ("... when first, and how far",
               [over.time - first, over.least - (0.7 - max (r.x(:,1)))], 1e-12);
  r = gsmbp_simulate (m, m.initial, 0:0.1:0.5, "input", 1e-4);
  gsmbp_check ("a run within all margins: none", isempty (r.stats.margins));
end

## the cylinders hold their loads; what the valve must be open for, follows
function fluids ()
  m = gsmbp_fixture ("trim_hydraulic");
  r = gsmbp_trim (m, m.initial, 0, "free", "C.u");
  force = m.par.C_a1 * r.x(3) - m.par.C_a2 * r.x(4);
  gsmbp_check ("hydraulic axis: pressures carry the load, of it", force / m.par.fl - 1, 1e-12);
  gsmbp_check ("hydraulic axis: what is left, of the usual sizes in a second", r.residual, 1e-12);
  gsmbp_check ("hydraulic axis: rates, of the usual sizes", rates (m, r), 1e-9);
  gsmbp_check ("hydraulic axis: it may stand anywhere, and stays where it was",
               isequal (r.indifferent, {"x"}) && r.x(1) == 0.3);
  said = gsmbp_complaint (@() gsmbp_trim (m, m.initial, 0));
  words = {"rate of C.p1 = ", " Pa/s", "these inputs act on it: C.u"};
  gsmbp_check ("hydraulic axis, valve as it is: the rows that are left and the input that helps",
               all (cellfun (@(w) any (strfind (said, w)), words)));
  p = gsmbp_fixture ("trim_pneumatic");
  r = gsmbp_trim (p, p.initial, [0; 0], "free", p.inputs);
  force = [p.par.C_a1, -p.par.C_a2] * (r.x([5, 7]) - p.par.C_pa);
  gsmbp_check ("pneumatic axis: pressures carry the load, of it", force / p.par.fl - 1, 1e-12);
  gsmbp_check ("pneumatic axis: temperatures are the walls'", r.x([6, 8, 10]) / 293 - 1, 1e-12);
  gsmbp_check ("pneumatic axis: both places as in the guess", r.x(1:2) - p.initial(1:2), 0);
  gsmbp_check ("pneumatic axis: rates, of the usual sizes", rates (p, r), 1e-9);
end

function f = rates (m, r)
  f = m.rhs (0, r.x, r.v) ./ m.nominal;
end

## springs of 10 and 1e10 N/m in one chain, an arm that turns through a large angle on a stiff guide
function stiff ()
  m = gsmbp_fixture ("trim_stiff");
  r = gsmbp_trim (m, m.initial, []);
  g = 9.81;
  wanted = -g * [6; 5; 3] ./ [m.par.ka; m.par.kb; m.par.kc];
  gsmbp_check ("stiff chain: what hangs on each spring, relative", r.x(1:3) ./ wanted - 1, 1e-12);
  phi = r.x(4);
  moment = -m.par.kt * (phi - 2) - g * (1 / 2 + 0.1 * r.x(5)) * cos (phi);
  gsmbp_check ("stiff arm: moments about the pin [N m]", moment, 1e-12);
  stretch = -0.1 * g * sin (phi) / m.par.kr;   # 1e-9 m, beside a length of 1 m
  gsmbp_check ("stiff arm: stretch of the guide, of itself", (r.x(5) - 1) / stretch - 1, 1e-5);
end

## a block that is driven, or begins to move, is not at rest; one whose drive stands still is
function moving ()
  m = gsmbp_fixture ("case_19a");
  said = gsmbp_complaint (@() gsmbp_trim (m, m.initial, []));
  gsmbp_check ("driven block at 3 m/s: refused, with the constraint and its rate",
               any (strfind (said, "the constraint P.motion moves at -3/s")));
  said = gsmbp_complaint (@() gsmbp_trim (m, m.initial, [], "time", pi / 120));
  gsmbp_check ("driven block where it turns back: refused",
               any (strfind (said, "P.motion starts with an acceleration of 180/s^2")));
  r = gsmbp_trim (gsmbp_set (m, "w", 0), [0; 2.9], []);
  gsmbp_check ("drive at rest: the rod stands", r.x(2) - pi, 1e-15);
  gsmbp_check ("drive at rest: the force carries the weight", r.lambda / (1.1 * 9.81) - 1, 1e-14);
end

## the four-bar from guesses all round: Newton's method does not stall, and goes on to rounding
function far ()
  m = gsmbp_fixture ("case_03a");
  left = [];
  for theta = (0:11) * pi / 6 + 0.1
    r = gsmbp_trim (m, [theta; -0.7; 1.2], 0);
    left(end+1) = max (abs ([r.ud; r.phi]));
  end
  gsmbp_check ("four-bar from twelve guesses: accelerations and gaps", left, 2e-12);
end

## an integrator without gain stays where it is: the cart goes to its reference
function integral ()
  m = gsmbp_fixture ("trim_integral");
  r = gsmbp_trim (gsmbp_set (m, "w", 0), gsmbp_set (m, "w", 0).initial, 2);
  gsmbp_check ("trim: integral, the cart is at its reference", ...
               r.x(strcmp (m.states, "xc")) - 2, 1e-12);
  gsmbp_check ("trim: integral, C.I stays 0", r.x(strcmp (m.states, "C.I")), 1e-12);
  ## a sensor settles on what the motion needs, not on what brings the state to the motion
  starts = [gsmbp_set(m, "baumgarte_alpha", 0).initial, m.initial];
  gsmbp_check ("start: filters do not know Baumgarte's constants", diff (starts, 1, 2), 1e-12);
end
