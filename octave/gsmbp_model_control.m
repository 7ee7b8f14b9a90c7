## -*- texinfo -*-
## @c category Linear models and control
## @deftypefn  {} {@var{c} =} gsmbp_model_control (@var{m}, @var{law}, @var{option}, @var{value}, @
## @dots{})
## @deftypefnx {} {@var{pp} =} gsmbp_model_control (@var{m}, "references", @var{plan})
## A controller that calculates with the equations of motion of the scene: computed torque,
## feedforward, impedance; through loops and drives.
##
## The model @var{m} has drives for all its freedoms, and outputs for the independent coordinates
## (all of an open chain, the actuated ones of a closed one) and their speeds.  The controller is a
## device of @file{share/controllers} in Fortran that calls subroutines of the scene, at samples:
## INV and MAS of an open chain with an ideal effort on each coordinate (word @code{drive}); else
## CLO, which closes the loops at what is measured, and the command of the drives (CMD; CMQ where
## drives have states), through motors, gears and rotors.
## @code{gsmbp_build (name, "controller", c)} builds the machine with it.  @var{law}:
## @table @code
## @item "computed torque"
## errors obey e'' + Kd e' + Kp e + Ki integral(e) = 0: Kp [1/s^2], Kd [1/s], Ki [1/s^3]
## @item "feedforward"
## inputs of the wanted motion (with its third derivative where motors have inductance), and a PID
## controller of each coordinate: Kp, Kd, Ki in units of the inputs
## @item "impedance"
## springs K and dampers D between the coordinates and the wanted motion, or "zeta", a damping ratio
## by the mass matrix where the machine is; the machine's inertia stays
## @item "cartesian impedance"
## springs K and dampers D between a tool ("frame": a point or frame of the scene) and the wanted
## pose: one number or three [N/m, N s/m] for shifts, six (three for turns [N m, N m s]), or a
## matrix 3 x 3 or 6 x 6; "axes" of K and D: "ground" or "tool"; "damping" of the coordinates beside
## @end table
##
## Options: "Kp", "Kd", "Ki", "K", "D", "zeta": a number or one for each coordinate; "period" [s]
## (needed), "delay", "limits", "step_out", "name" as in @code{gsmbp_control}; "measured", "inputs":
## names of outputs (all independent coordinates, then their speeds) and of inputs of the drives,
## where they are not found by what they are.  "parameters": a struct of values that the controller
## believes instead of those of the machine.  "trim": the result of @code{gsmbp_trim} (or a struct
## with x) where a run starts, default @code{m.initial}: references, held inputs and the branch of
## the loops are there.  Where the loops do not close at what is measured (at what is wanted, of a
## feedforward) the inputs stay as they were.
##
## The references are inputs behind those of the scene: coordinates, then their rates, then their
## accelerations; of a tool its place and the rotation vector of its axes, then their rates.
## @code{"references"} makes the "input" of @code{gsmbp_simulate} for the machine
## with the controller of a @var{plan} of all of them (@code{gsmbp_plan}); other inputs are
## zero.
##
## @c session octave
## @example
## >> file = fopen ("turret.mac", "w");
## >> fputs (file, "scene : gsmbp_scene(\"turret\", link(gun, mass = m, centre = [l, 0, 0]), ");
## >> fputs (file, "revolute(A, ground, gun, axis = z, coordinate = q), ");
## >> fputs (file, "input(tau, unit = N*m), drive(D, joint = A, effort = tau), ");
## >> fputs (file, "output(angle, q), output(speed, q_d), parameters = [m = 2*kg, l = 0.3*m])$");
## >> fclose (file);
## >> gsmbp_derive ("turret.mac", "fortran_out");
## ...
## >> m = gsmbp_build ("turret");
## >> c = gsmbp_model_control (m, "computed torque", "Kp", 100, "Kd", 20, "period", 1e-3);
## >> mc = gsmbp_build ("turret", "controller", c);
## >> plan = gsmbp_plan ("quintic", [0 1], [0 1]);
## >> law = gsmbp_model_control (mc, "references", plan);
## >> r = gsmbp_simulate (mc, [0.1; 0], [0 1], "input", law);
## >> round (1e3 * r.x(:,1)')
## ans =
##
##     100   1000
## @end example
##
## Errors: Euler parameters; freedoms without a drive; inputs that are no drives'; loops that do not
## close at the start; no output for a coordinate or speed; no period.
## Source: Siciliano, Sciavicco, Villani, Oriolo, Robotics (inverse dynamics control, impedance).
## @seealso{gsmbp_build, gsmbp_control, gsmbp_plan, gsmbp_simulate}
## @end deftypefn

function c = gsmbp_model_control (m, law, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_model_control";
  gs.given.check_model (who, m);
  laws = {"computed torque", "feedforward", "impedance", "cartesian impedance", "references"};
  gs.given.check_kind (who, "argument law", law, laws);
  if (strcmp (law, "references"))
    c = references (who, m, varargin{1});
    return;
  endif
  table = {"Kp", 0, "numbers"; "Kd", 0, "numbers"; "Ki", 0, "numbers"; "K", 0, "numbers"
           "D", 0, "numbers"; "zeta", 0, "nonnegative"; "period", 0, "nonnegative"
           "delay", 0, "nonnegative"; "limits", Inf, "any"; "step_out", 0, "nonnegative"
           "name", "ctl", "text"; "measured", {}, "names"; "inputs", {}, "names"
           "parameters", struct(), "any"; "trim", [], "any"; "frame", "", "text"
           "axes", "ground", {"ground", "tool"}; "damping", 0, "numbers"};
  o = gs.given.call_options (who, table, varargin);
  gs.controller.check_name (who, o);
  check_scene (who, m, o);
  check_gains (who, law, o);
  if (gs.control.ideal_efforts (m, o) && ! strcmp (law, "cartesian impedance"))
    c = gs.control.effort_law (who, m, o, law);
    measured_ = 1:m.sizes.nu;
  else
    c = gs.control.drive_law (who, m, o, law);
    measured_ = c.through.independent;
  endif
  c.measured = measured (who, m, o, measured_);
  if (strcmp (law, "cartesian impedance"))
    c = gs.control.tool_law (who, m, o, c);
  else
    c = of_coordinates (who, m, o, c, measured_);
  endif
  c.limits = gs.given.two_limits (who, o.limits, c.driven, zeros (size (c.u0)));
  c.u0 = within (who, o, c);
  c.step_out = repmat (o.step_out, numel (c.driven), 1);
  c.cst = [];
  believed = m;
  if (! isempty (fieldnames (o.parameters)))
    if (! strcmp (m.precision, "double"))
      error ("%s: option parameters: expected a model in double precision, found %s", who, ...
             m.precision);
    endif
    believed = gsmbp_set (m, o.parameters);
    c.cst = typecast (believed.cst, "double");
  endif
  c.scene = struct ("name", m.name, "hash", m.scene_hash, "parameters", believed.par);
endfunction

## gains and references of laws in coordinates
function c = of_coordinates (who, m, o, c, k)
  n = numel (k);
  for gain = {"Kp", "Kd", "Ki", "K", "D"}
    c.(gain{1}) = spread (who, gain{1}, o.(gain{1}), n);
  endfor
  c.zeta = o.zeta;
  order = 2;
  if (isfield (c, "through"))
    order = c.through.derivatives;
  endif
  c.references = c.units = cell (0, 1);
  for j = 0:order
    c.references = [c.references; strcat(m.coordinates(k), gs.text.derivative_name (j))];
    c.units = [c.units; cellfun(@(u) derived (u, j), m.units.coordinates(k)(:), ...
                                "UniformOutput", false)];
  endfor
  x = m.initial;
  if (! isempty (o.trim))
    x = o.trim.x(:);
  endif
  c.r0 = [x(k); x(m.sizes.nq + k); zeros((order - 1) * n, 1)];
endfunction

function unit = derived (unit, k)
  if (k == 1)
    unit = [unit "/s"];
  elseif (k > 1)
    unit = sprintf ("%s/s^%d", unit, k);
  endif
endfunction

## a plan with its derivatives, one below the other, for the inputs of M that no device holds; those
## that are no references are zero
function pp = references (who, m, plan)
  free = setdiff (1:m.sizes.nv, vertcat (m.controllers.outputs));
  names = regexprep (m.inputs(free), '^.*\.', "");
  base = regexprep (names(! cellfun (@isempty, regexp (names, '_ref$'))), '_ref$', "");
  base = base(ismember (strcat (base, "_d_ref"), names));
  n = numel (base);
  if (n == 0)
    error (["%s: %s has no inputs that are references of its coordinates; expected the model " ...
            "of gsmbp_build (name, \"controller\", c)"], who, m.name);
  endif
  plan = gs.given.given_polynomial (who, plan, n, ["argument plan (" strjoin(base', ", ") ")"]);
  all_ = zeros (numel (free), plan.pieces, plan.order);
  d = plan;
  k = 0;
  at = gs.given.places_of (strcat (base, "_ref"), names);
  while (all (at))
    all_(at,:,plan.order-d.order+1:end) = reshape (d.coefs, n, plan.pieces, d.order);
    d = ppder (d);
    k += 1;
    at = gs.given.places_of (strcat (base, gs.text.derivative_name (k)), names);
  endwhile
  pp = mkpp (plan.breaks, reshape (all_, [], plan.order), numel (free));
endfunction

function check_scene (who, m, o)
  d = m.sizes;
  if (d.nq != d.nu)
    error (["%s: %s: expected speeds that are the rates of its coordinates; found %d " ...
            "coordinates and %d speeds"], who, m.name, d.nq, d.nu);
  endif
  if (! any (strcmp (m.subroutines, "inv")))
    error ("%s: %s was emitted without INV: add the request inverse", who, m.name);
  endif
  if (! (isempty (o.trim) || (isstruct (o.trim) && isfield (o.trim, "x"))))
    error ("%s: option trim: expected the result of gsmbp_trim, found a %s", who, class (o.trim));
  endif
  if (! (o.period > 0))
    error ("%s: option period: expected the sampling period [s] of the controller, found 0", who);
  endif
endfunction

## inputs that are held before the first command; a trim that they cannot hold is told
function u = within (who, o, c)
  u = min (max (c.u0, c.limits(:,1)), c.limits(:,2));
  k = find (u != c.u0, 1);
  if (! isempty (k) && ! isempty (o.trim))
    warning ("gsmbp:limits", "%s: %s has to be %g at the trim, beyond its limits %g and %g", ...
             who, c.driven{k}, c.u0(k), c.limits(k,:));
  endif
endfunction

## gains of another law say nothing here
function check_gains (who, law, o)
  taken = {"Kp", "Kd", "Ki"};
  if (strcmp (law, "impedance"))
    taken = {"K", "D", "zeta"};
  elseif (strcmp (law, "cartesian impedance"))
    taken = {"K", "D", "damping", "frame"};
  endif
  for name = setdiff ({"Kp", "Kd", "Ki", "K", "D", "zeta", "damping", "frame"}, taken)
    if (any (o.(name{1})(:) != 0))
      error ("%s: option %s: %s has none, expected %s", who, name{1}, law, ...
             strjoin (taken, ", "));
    endif
  endfor
  if (o.zeta != 0 && any (o.D(:) != 0))
    error ("%s: option zeta: expected zeta or D, found both", who);
  elseif (! strcmp (law, "feedforward") && all (o.(taken{1})(:) == 0))
    error ("%s: option %s: %s needs it, a number > 0; found none", who, taken{1}, law);
  endif
endfunction

function v = spread (who, name, v, n)
  if (isscalar (v))
    v = repmat (v, n, 1);
  endif
  v = double (v(:));
  if (numel (v) != n || any (v < 0) || ! all (isfinite (v)))
    error ("%s: option %s: expected %snumbers that are not negative, found %s", who, name, ...
           {sprintf("1 or %d ", n), "1 of "}{1 + (n == 1)}, gs.text.shown_value (v));
  endif
endfunction

## outputs that are coordinates and speeds
function names = measured (who, m, o, k)
  names = gs.given.asked_names (o.measured);
  wanted = [m.coordinates(k); m.speeds(k)];
  if (isempty (names))
    list = gs.model.json_rows (m.json, "outputs");
    said = cellfun (@(row) row.expression, list, "UniformOutput", false);
    for k = 1:numel (wanted)
      at = find (strcmp (said, wanted{k}), 1);
      if (isempty (at))
        error (["%s: %s: expected an output that is %s, found none: add output(name, %s), or " ...
                "name it in option measured"], who, m.name, wanted{k}, wanted{k});
      endif
      names{k,1} = list{at}.name;
    endfor
  endif
  if (! all (gs.given.places_of (names, m.outputs)))
    error ("%s: option measured: expected names of outputs, found %s", who, ...
           gs.text.nearest_word (names{find (! gs.given.places_of (names, m.outputs), 1)}, ...
                                 m.outputs));
  endif
  if (numel (names) != numel (wanted))
    error ("%s: option measured: expected %d outputs (%s), found %d", who, numel (wanted), ...
           strjoin (wanted', ", "), numel (names));
  endif
  is_one (who, m, names, wanted);
endfunction

## an output of another unit than its coordinate or speed is none of it, nor is another one of them
function is_one (who, m, names, wanted)
  rows = gs.model.json_rows (m.json, "outputs");
  listed = cellfun (@(row) row.name, rows, "UniformOutput", false);
  for k = 1:numel (names)
    said = rows{strcmp (listed, names{k})}.expression;
    if (any (strcmp (said, wanted)) && ! strcmp (said, wanted{k}))
      error (["%s: option measured: expected an output that is %s in place %d; found %s, " ...
              "which is %s"], who, wanted{k}, k, names{k}, said);
    endif
    unit = m.units.outputs{strcmp (m.outputs, names{k})};
    needed = m.units.states{strcmp (m.states, wanted{k})};
    plain = @(unit) regexprep (unit, '\<rad\>', "1");
    if (! any (strcmp (unit, {"", "1"})) && ! strcmp (plain (unit), plain (needed)))
      error (["%s: option measured: expected an output that is %s, in %s; found %s, in %s"], ...
             who, wanted{k}, needed, names{k}, unit);
    endif
  endfor
endfunction

%!error <Invalid call> gsmbp_model_control (1)
%!error <argument law: expected one of>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! gsmbp_model_control (gsmbp_hand ("motor_pendulum"), "magic", "Kp")
%!error <expected the sampling period>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! gsmbp_model_control (gsmbp_hand ("motor_pendulum"), "impedance", "K", 1)
