## -*- texinfo -*-
## @c category Linear models and control
## @deftypefn  {} {@var{c} =} gsmbp_model_control (@var{m}, @var{law}, @var{option}, @var{value}, @
## @dots{})
## @deftypefnx {} {@var{pp} =} gsmbp_model_control (@var{m}, "references", @var{plan})
## A controller that calculates with the equations of motion of the scene: computed torque,
## feedforward, impedance.
##
## The model @var{m} is of an open chain with an ideal effort as input for each speed (word
## @code{drive}), and outputs for its coordinates and speeds.  The controller is a device of
## @file{share/controllers} in Fortran that calls the emitted INV (and MAS) of the scene, at
## samples;
## @code{gsmbp_build (name, "controller", c)} builds the machine with it.  @var{law}:
## @table @code
## @item "computed torque"
## errors obey e'' + Kd e' + Kp e + Ki integral(e) = 0: Kp [1/s^2], Kd [1/s], Ki [1/s^3]
## @item "feedforward"
## INV of the wanted motion, and a PID controller of each coordinate: Kp, Kd, Ki in efforts
## @item "impedance"
## springs K and dampers D between the coordinates and the wanted motion, or "zeta", a damping ratio
## by the mass matrix where the chain is
## @end table
##
## Options: "Kp", "Kd", "Ki", "K", "D", "zeta": a number or one for each coordinate; "period" [s]
## (needed), "delay", "limits", "step_out", "name" as in @code{gsmbp_control}; "measured", "inputs":
## names of outputs (all coordinates, then all speeds) and of inputs (in the order of the speeds),
## where they are not found by what they are.  "parameters": a struct of values that the controller
## believes instead of those of the machine.
##
## The references are inputs behind those of the scene: coordinates, then their rates, then their
## accelerations.  @code{"references"} makes the "input" of @code{gsmbp_simulate} for the machine
## with the controller of a @var{plan} of all coordinates (@code{gsmbp_plan}); other inputs are
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
## >> r = gsmbp_simulate (mc, [0.1; 0], [0 1], "input", ...
##                        gsmbp_model_control (mc, "references", plan));
## >> round (1e3 * r.x(:,1)')
## ans =
##
##     100   1000
## @end example
##
## Errors: a scene with loops or Euler parameters; inputs that are no efforts of the speeds; no
## output for a coordinate or speed; no period.
## Source: Siciliano, Sciavicco, Villani, Oriolo, Robotics (inverse dynamics control, impedance).
## @seealso{gsmbp_build, gsmbp_control, gsmbp_plan, gsmbp_simulate}
## @end deftypefn

function c = gsmbp_model_control (m, law, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_model_control";
  gsmbp__model (who, m);
  laws = {"computed torque", "feedforward", "impedance", "references"};
  gsmbp__fits (who, "argument law", law, laws);
  n = m.sizes.nu;
  if (strcmp (law, "references"))
    c = references (who, m, gsmbp__pp (who, varargin{1}, n, "argument plan"), n);
    return;
  endif
  table = {"Kp", 0, "numbers"; "Kd", 0, "numbers"; "Ki", 0, "numbers"; "K", 0, "numbers"
           "D", 0, "numbers"; "zeta", 0, "nonnegative"; "period", 0, "nonnegative"
           "delay", 0, "nonnegative"; "limits", Inf, "any"; "step_out", 0, "nonnegative"
           "name", "ctl", "text"; "measured", {}, "names"; "inputs", {}, "names"
           "parameters", struct(), "any"};
  o = gsmbp__options (who, table, varargin);
  check_scene (who, m, o);
  c = struct ("method", law, "name", o.name, "period", o.period, "delay", o.delay);
  for gain = {"Kp", "Kd", "Ki", "K", "D"}
    c.(gain{1}) = spread (who, gain{1}, o.(gain{1}), n);
  endfor
  c.zeta = o.zeta;
  c.measured = measured (who, m, o);
  c.driven = driven (who, m, o);
  c.references = [strcat(m.coordinates, "_ref"); strcat(m.coordinates, "_d_ref"); ...
                  strcat(m.coordinates, "_dd_ref")];
  [c.A, c.u0] = deal (eye (n), zeros (n, 1));
  c.r0 = [m.initial(1:n); zeros(2 * n, 1)];
  c.limits = gsmbp__two_limits (who, o.limits, c.driven, c.u0);
  c.step_out = repmat (o.step_out, n, 1);
  c.cst = [];
  if (! isempty (fieldnames (o.parameters)))
    if (! strcmp (m.precision, "double"))
      error ("%s: option parameters: expected a model in double precision, found %s", who, ...
             m.precision);
    endif
    c.cst = typecast (gsmbp_set (m, o.parameters).cst, "double");
  endif
endfunction

## a plan with its rates and accelerations, one below the other, for the inputs of M that no device
## holds; those that are no references are zero
function pp = references (who, m, plan, n)
  free = setdiff (1:m.sizes.nv, vertcat (m.controllers.outputs));
  names = regexprep (m.inputs(free), '^.*\.', "");
  at = gsmbp__which ([strcat(m.coordinates, "_ref"); strcat(m.coordinates, "_d_ref"); ...
                      strcat(m.coordinates, "_dd_ref")], names);
  if (! all (at))
    error (["%s: %s has no inputs that are references of its coordinates; expected the model " ...
            "of gsmbp_build (name, \"controller\", c)"], who, m.name);
  endif
  d = ppder (plan);
  dd = ppder (d);
  k = plan.order;
  all_ = zeros (numel (free), plan.pieces, k);
  coefs = zeros (3 * n, plan.pieces, k);
  parts = {plan, d, dd};
  for i = 1:3
    p = parts{i};
    own = reshape (p.coefs, n, plan.pieces, p.order);
    coefs((i - 1) * n + (1:n),:,k - p.order + 1:k) = own;
  endfor
  all_(at,:,:) = coefs;
  pp = mkpp (plan.breaks, reshape (all_, [], k), numel (free));
endfunction

function check_scene (who, m, o)
  d = m.sizes;
  if (d.nlam > 0 || d.nq != d.nu)
    error (["%s: %s: expected an open chain whose speeds are rates of its coordinates; found " ...
            "%d constraints, %d coordinates and %d speeds"], who, m.name, d.nlam, d.nq, d.nu);
  endif
  if (! all (ismember ({"inv", "mas", "jac"}, m.subroutines)))
    error (["%s: %s was emitted without INV, MAS or JAC: add the requests inverse, mass, " ...
            "jacobian"], who, m.name);
  endif
  if (! (o.period > 0))
    error ("%s: option period: expected the sampling period [s] of the controller, found 0", who);
  endif
endfunction

function v = spread (who, name, v, n)
  if (isscalar (v))
    v = repmat (v, n, 1);
  endif
  v = double (v(:));
  if (numel (v) != n || any (v < 0) || ! all (isfinite (v)))
    error ("%s: option %s: expected 1 or %d numbers that are not negative, found %s", who, name, ...
           n, gsmbp__shown (v));
  endif
endfunction

## outputs that are coordinates and speeds
function names = measured (who, m, o)
  names = cellstr (o.measured)(:);
  names = names(! cellfun (@isempty, names));
  wanted = [m.coordinates; m.speeds];
  if (isempty (names))
    list = gsmbp__rows (m.json, "outputs");
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
  if (numel (names) != numel (wanted))
    error ("%s: option measured: expected %d outputs (%s), found %d", who, numel (wanted), ...
           strjoin (wanted', ", "), numel (names));
  endif
endfunction

## inputs that are the efforts on the speeds
function names = driven (who, m, o)
  names = cellstr (o.inputs)(:);
  names = names(! cellfun (@isempty, names));
  if (isempty (names))
    names = m.inputs;
  endif
  k = gsmbp__which (names, m.inputs);
  n = m.sizes.nu;
  if (numel (names) != n || ! all (k))
    error ("%s: expected an input for each of the %d speeds (option inputs), found %s", who, n, ...
           strjoin (names', ", "));
  endif
  [~, B] = m.jac (0, m.initial, zeros (m.sizes.nv, 1));
  E = m.mas (0, m.initial(1:n)) * B(n + (1:n),k);
  [i, j] = find (abs (E - eye (n)) > 1e-9, 1);
  if (! isempty (i) || m.sizes.nx > 2 * n)
    error (["%s: %s: expected ideal efforts (word drive) in the order of the speeds %s: an " ...
            "input of 1 has to give an effort of 1 on its own speed at once; found others"], ...
           who, ...
           m.name, strjoin (m.speeds', ", "));
  endif
endfunction

%!error <Invalid call> gsmbp_model_control (1)
%!error <argument law: expected one of>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! gsmbp_model_control (gsmbp_hand ("motor_pendulum"), "magic", "Kp")
%!error <expected the sampling period>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! gsmbp_model_control (gsmbp_hand ("motor_pendulum"), "impedance", "K", 1)
