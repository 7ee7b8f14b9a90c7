## -*- texinfo -*-
## @c category Positions and equilibria
## @deftypefn  {} {@var{p} =} gsmbp_point (@var{m}, @var{name}, @var{t}, @var{q})
## @deftypefnx {} {@var{p} =} gsmbp_point (@var{m}, @var{name}, @var{t}, @var{q}, @var{u})
## @deftypefnx {} {@var{p} =} gsmbp_point (@var{m}, @var{name}, @var{t}, @var{q}, @var{u}, @var{ud})
## @deftypefnx {} {@var{p} =} gsmbp_point (@dots{}, @var{option}, @var{value}, @dots{})
## Where a point or frame of the scene is and how it moves.
##
## @var{name} is a @code{point} or @code{frame} of the scene of the model @var{m}
## (@code{m.points}), @var{t} the time [s], @var{q} the coordinates, @var{u} the speeds,
## @var{ud} their rates.  @var{p} has the fields
##
## @table @code
## @item position
## of the point, from the origin of ground [m]
## @item rotation
## 3 x 3, the columns are the axes of the frame (of the link, for a point)
## @item euler_parameters
## four, scalar first and not negative
## @item roll_pitch_yaw
## angles with @code{rotation} = Rz(yaw)*Ry(pitch)*Rx(roll) [rad]
## @end table
##
## and, where @var{u} is given,
##
## @table @code
## @item jacobian
## 6 x @var{nu}: @code{[velocity; angular_velocity] = jacobian*u}
## @item jacobian_rate
## the rate of the Jacobian times u, six numbers
## @item velocity, angular_velocity
## of the point [m/s] and of its link [rad/s], against ground
## @end table
##
## and, where @var{ud} is given, @code{acceleration} [m/s^2] and
## @code{angular_acceleration} [rad/s^2].
##
## Options:
## @table @code
## @item "frame"
## @qcode{"ground"} (default), a point or frame of the scene or a link that carries one, in whose
## axes all of this is.  @code{jacobian_rate} is then the rate of the Jacobian in these axes,
## times u
## @item "independent"
## of a closed chain the names of as many coordinates as there are freedoms: the columns of
## @code{jacobian} are then by their speeds w, and @code{jacobian_rate} is what the
## accelerations hold beside @code{jacobian*wd}.  @var{q} must be closed and @var{u} fulfil the
## constraints (@code{gsmbp_assemble})
## @end table
##
## All states at once, and without names: the handles @code{m.pnt}, @code{m.jpt} and their batches
## @code{m.pnt_v}, @code{m.jpt_v}; both in one call: @code{m.pnj}, with (dJ/dt)*u @code{m.pnr}.
##
## @c session octave
## @example
## >> gsmbp_derive ("examples/puma560/puma560.mac", "fortran_out");
## ...
## >> m = gsmbp_build ("puma560");
## >> p = gsmbp_point (m, "wrist", 0, [0.3; -0.2; 0.5], [1; 2; 0]);
## >> p.position'
## ans =
##
##    0.345255  -0.050265   0.332728
## >> p.velocity'
## ans =
##
##   -0.5855   0.1486   0.6300
## >> p.jacobian
## ans =
##
##    0.0503  -0.3179  -0.3998
##    0.3453  -0.0983  -0.1237
##         0   0.3150  -0.1082
##         0   0.2955   0.2955
##         0  -0.9553  -0.9553
##    1.0000        0        0
## >> p = gsmbp_point (m, "wrist", 0, [0.3; -0.2; 0.5], [1; 2; 0], "frame", "wrist");
## >> p.velocity'
## ans =
##
##   -0.3062   0.3150   0.7541
## @end example
##
## Errors: no such point; a position or a speed of another size; coordinates from which the motion
## of the others does not follow.
## Source: own; Craig, Introduction to Robotics (1989), for the Jacobian.
## @seealso{gsmbp_operational, gsmbp_reduced, gsmbp_build}
## @end deftypefn

function p = gsmbp_point (m, name, t, q, varargin)
  if (nargin < 4)
    print_usage ();
  endif
  who = "gsmbp_point";
  gs.given.check_model (who, m);
  gs.given.refuse_words (who, "t", t, "q", q);
  first = find (cellfun (@ischar, varargin), 1);
  if (isempty (first))
    first = numel (varargin) + 1;
  endif
  motion = varargin(1:first-1);
  options = gs.given.call_options (who, {"frame", "ground", "text"; "independent", {}, "names"}, ...
                                   varargin(first:end));
  if (numel (motion) > 2)
    print_usage ();
  endif
  [P, R] = m.pnt (t, q);
  k = number (who, m, "point", name);
  axes_ = @(k) R(:,3*k-2:3*k);
  A = eye (3);
  turning = 0;
  if (! strcmp (options.frame, "ground"))
    [turning, local] = bearer (who, m, options.frame);
    A = axes_ (turning) * local';
  endif
  p.position = A' * P(:,k);
  p.rotation = A' * axes_ (k);
  [p.euler_parameters, p.roll_pitch_yaw] = gs.plan.euler_parameters (p.rotation);
  if (! isempty (motion))
    p = moving (who, m, p, k, A, turning, t, q, options, motion{:});
  elseif (! isempty (options.independent))
    error ("%s: option independent: expected speeds u behind q", who);
  endif
endfunction

## the same with velocities, Jacobian, accelerations in the axes A, which turn with the point
## TURNING (0: with none)
function p = moving (who, m, p, k, A, turning, t, q, options, u, ud = [])
  n = m.sizes.nu;
  u = gs.given.given_vector (who, "u", u, n, "", m.speeds);
  [J, dJu] = m.jpt (t, q, u);
  block = @(k) J(:,n*(k-1)+1:n*k);
  w = zeros (3, 1);
  if (turning > 0)
    w = A' * block (turning)(4:6,:) * u;
  endif
  J = block (k);
  dJu = dJu(:,k);
  B = blkdiag (A, A);
  V = B' * J * u;
  if (! isempty (ud))
    a = B' * (J * gs.given.given_vector (who, "ud", ud, n, "", m.speeds) + dJu);
  endif
  if (! isempty (options.independent))
    [T, c] = gs.linear.independent_speeds (who, "option independent", m, t, q, u, ...
                                  options.independent);
    dJu += J * c;
    J *= T;
  endif
  p.jacobian = B' * J;
  ## the axes turn: (A'J)' u = A'(J' u) - w x (A'J u)
  p.jacobian_rate = B' * dJu - [cross(w, V(1:3)); cross(w, V(4:6))];
  p.velocity = V(1:3);
  p.angular_velocity = V(4:6);
  if (! isempty (ud))
    p.acceleration = a(1:3);
    p.angular_acceleration = a(4:6);
  endif
endfunction

## the point or frame whose axes are wanted, or that stands on the link whose are; its axes in these
function [k, local] = bearer (who, m, name)
  local = eye (3);
  k = find (strcmp (name, m.points));
  if (! isempty (k))
    return;
  endif
  k = find (strcmp ({m.json.points.link}, name), 1);
  if (! isempty (k))
    local = reshape (cellfun (@(text) constant (m, text), m.json.points(k).rotation), 3, 3)';
  elseif (any (strcmp (m.skeleton.body, name)))
    error (["%s: option frame: link %s carries no point or frame: expected one that does, or a " ...
            "point or frame: %s"], who, name, strjoin (m.points(:)', ", "));
  else
    k = number (who, m, "frame", name);
  endif
endfunction

## an expression of the JSON in the parameters
function x = constant (m, text)
  f = str2func (["@(" strjoin(fieldnames (m.par)', ", ") ") " strrep(text, "%", "")]);
  x = f (struct2cell (m.par){:});
endfunction

function k = number (who, m, what, name)
  if (! ischar (name))
    error ("%s: argument name: expected a text, found %s", who, gs.text.shown_value (name));
  endif
  k = find (strcmp (name, m.points));
  if (isempty (k))
    error ("%s: unknown %s %s", who, what, gs.text.nearest_word (name, m.points));
  endif
endfunction

%!error <Invalid call> gsmbp_point (1)
