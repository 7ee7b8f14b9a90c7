## -*- texinfo -*-
## @c category Positions and equilibria
## @deftypefn  {} {@var{o} =} gsmbp_operational (@var{m}, @var{name}, @var{t}, @var{q}, @var{u})
## @deftypefnx {} {@var{o} =} gsmbp_operational (@dots{}, @var{option}, @var{value}, @dots{})
## Operational-space inertia and bias of a point or frame, and its manipulability.
##
## For the point or frame @var{name} of the model @var{m} (see @code{gsmbp_point} for the
## arguments) with the Jacobian J and the acceleration a = J*ud + (dJ/dt)*u, the forces and moments
## that are to act on it are @code{inertia*a + bias}.  @var{o} has the fields
##
## @table @code
## @item inertia
## inv (J*inv (M)*J'), the operational-space inertia
## @item bias
## what velocities, gravity, passive and given forces ask for there
## @item manipulability
## sqrt (det (J*J')), the volume of the velocities that speeds of length 1 give
## @item singular_values
## of J, and
## @item condition
## their ratio, largest over smallest
## @item jacobian, jacobian_rate
## as of @code{gsmbp_point}, the rows asked for
## @end table
##
## Options:
## @table @code
## @item "rows"
## which of vx, vy, vz, wx, wy, wz are asked for (1:6 by default): as many as can be given
## independently
## @item "frame"
## in whose axes these are, as of @code{gsmbp_point}
## @item "independent"
## of a closed chain the names of independent coordinates (see @code{gsmbp_reduced})
## @item "inputs"
## the inputs of the scene (0 by default), which the bias may hold
## @end table
##
## Manipulability and condition mix m and rad unless @code{rows} are of one kind.
##
## @c session octave
## @example
## >> gsmbp_derive ("examples/puma560/puma560.mac", "fortran_out");
## ...
## >> m = gsmbp_build ("puma560");
## >> q = [0.3; -0.2; 0.5];
## >> o = gsmbp_operational (m, "wrist", 0, q, zeros (3, 1), "rows", 1:3);
## >> o.inertia
## ans =
##
##     7.9032  -10.5686   -4.2684
##   -10.5686   32.6685    1.2497
##    -4.2684    1.2497   25.9969
## >> o.bias'
## ans =
##
##   -19.5750    2.8499   78.0698
## >> o.manipulability
## ans = 0.052863
## @end example
##
## Errors: a singular pose, or more rows than freedoms: rows that cannot be moved
## independently have no inertia.
## Source: Khatib, IEEE Journal of Robotics and Automation 3(1), 1987; Yoshikawa, International
## Journal of Robotics Research 4(2), 1985.
## @seealso{gsmbp_point, gsmbp_reduced}
## @end deftypefn

function o = gsmbp_operational (m, name, t, q, u, varargin)
  if (nargin < 5)
    print_usage ();
  endif
  who = "gsmbp_operational";
  gs.given.check_model (who, m);
  gs.given.refuse_words (who, "t", t, "q", q, "u", u);
  table = {"rows", 1:6, "numbers"; "frame", "ground", "text"; "independent", {}, "names"
           "inputs", [], "numbers"};
  options = gs.given.call_options (who, table, varargin);
  k = options.rows(:)';
  if (isempty (k) || any (k != fix (k)) || any (k < 1 | k > 6) || numel (unique (k)) != numel (k))
    error ("%s: option rows: expected different numbers from 1 to 6, found %s", who, ...
           gs.text.shown_value (options.rows));
  endif
  p = gsmbp_point (m, name, t, q, u, "frame", options.frame, "independent", options.independent);
  if (isempty (options.independent))
    M = m.mas (t, q);
    b = m.bia (t, q, u, options.inputs);
  else
    r = gsmbp_reduced (m, t, q, u, options.independent, options.inputs);
    [M, b] = deal (r.M, r.bias);
  endif
  o.jacobian = p.jacobian(k,:);
  o.jacobian_rate = p.jacobian_rate(k);
  o.singular_values = svd (o.jacobian);
  s = [o.singular_values; zeros(numel (k) - numel (o.singular_values), 1)];
  o.condition = s(1) / s(end);
  o.manipulability = prod (s);
  if (s(end) <= 1e-12 * s(1))
    error (["%s: singular: the rows %s of %s cannot be moved independently here; expected " ...
            "fewer rows or another position"], who, mat2str (k), name);
  endif
  A = M \ [o.jacobian', b];
  o.inertia = inv (o.jacobian * A(:,1:end-1));
  o.inertia = (o.inertia + o.inertia') / 2;
  ## p.jacobian_rate is of the axes of the option frame: so is the acceleration
  o.bias = o.inertia * (o.jacobian * A(:,end) - o.jacobian_rate);
endfunction

%!error <Invalid call> gsmbp_operational (1, 2)
