## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {@var{c} =} gsmbp_cycle (@var{m}, @var{result}, @var{name})
## @deftypefnx {} {@var{c} =} gsmbp_cycle (@var{table}, @var{option}, @var{value}, @dots{})
## The load cycle of a drive: what an axis asks of what moves it.
##
## In the first form that of the coordinate @var{name} (may be left out where one alone is moved) of
## the model @var{m} along a @var{result} of @code{gsmbp_inverse} (a plan) or of
## @code{gsmbp_simulate} (a run).  The load must not count the motor that is looked for: the scene
## has an ideal source there (word @code{drive}), or the inertia and friction of its motor and gear
## are set to 0 (@code{gsmbp_set}).
##
## In the second form from a @var{table} with the columns time [s], speed, acceleration and torque
## at the output of the gear (of an axis that slides, "unit", "m": speed [m/s], acceleration and
## force [N]).  Options: "unit": "rad" (default) or "m"; "inertia" [kg*m^2, or kg]: the inertia that
## the output of the gear drives, for the limit of the inertia ratio; "position": a number for each
## time.
##
## @var{c} is a struct with the columns @code{t}, @code{position}, @code{omega}, @code{alpha},
## @code{torque}, and @code{inertia}, the largest along the cycle (NaN: not known), @code{unit}.
## rms values, means and energies are those of the trapezoidal rule over these samples.
##
## @c session octave
## @example
## >> t = (0:0.01:1)';
## >> c = gsmbp_cycle ([t, 6*t.*(1-t), 6-12*t, 5*(6-12*t) + 20]);
## >> [numel(c.t), max(c.torque)]
## ans =
##
##    101    50
## @end example
##
## Errors: a coordinate that is not moved; a motor whose inertia or friction is counted (a warning
## where its parameters have names of the scene's own); times that do not increase; a table of
## another width; numbers that are not finite.
## Source: own.
## @seealso{gsmbp_drive, gsmbp_cylinder, gsmbp_inverse}
## @end deftypefn

function c = gsmbp_cycle (m, varargin)
  if (nargin < 1)
    print_usage ();
  endif
  who = "gsmbp_cycle";
  if (isnumeric (m))
    c = of_table (who, m, varargin);
    return;
  endif
  gs.given.check_model (who, m);
  if (numel (varargin) < 1 || numel (varargin) > 2)
    print_usage ();
  endif
  r = varargin{1};
  if (! (isstruct (r) && isscalar (r) && all (isfield (r, {"t", "x", "v"}))))
    error ("%s: argument result: expected a struct with the fields t, x, v, found %s", who, ...
           gs.text.shown_value (r));
  endif
  load_alone (who, m);
  [column, k] = moved (who, m, varargin(2:end));
  c = along (who, m, r, column, k);
endfunction

function c = of_table (who, table, pairs)
  o = gs.given.call_options (who, {"unit", "rad", {"rad", "m"}; "inertia", NaN, "positive"
                                   "position", [], "numbers"}, pairs);
  if (! (isreal (table) && columns (table) == 4 && rows (table) > 1))
    error (["%s: argument table: expected a row of time, speed, acceleration and torque for " ...
            "each of two or more times, found %s"], who, gs.text.shown_value (table));
  endif
  gs.given.check_table (who, "argument table", table);
  c.t = gs.given.given_times (who, table(:,1))';
  c.position = o.position(:);
  if (isempty (c.position))
    c.position = NaN (size (c.t));
  elseif (numel (c.position) != numel (c.t))
    error ("%s: option position: expected %d numbers, found %d", who, numel (c.t), ...
           numel (c.position));
  endif
  [c.omega, c.alpha, c.torque] = deal (table(:,2), table(:,3), table(:,4));
  [c.inertia, c.unit] = deal (o.inertia, o.unit);
endfunction

## what a motor in the scene adds would count twice
function load_alone (who, m)
  for d = gs.model.json_rows (m.json, "devices")
    [name, entry] = deal (d{1}.name, d{1}.entry);
    for letter = {"J", "B", "tc", "Tc"}
      parameter = [name "_" letter{1}];
      if (isfield (m.par, parameter) && m.par.(parameter) != 0)
        error (["%s: the load counts %s = %.6g of %s %s: expected a scene with an ideal source " ...
                "(word drive), or gsmbp_set (m, \"%s\", 0)"], who, parameter, ...
               m.par.(parameter), entry, name, parameter);
      endif
    endfor
    if (! isempty (strfind (entry, "motor")) && ! isfield (m.par, [name "_J"]))
      warning ("gsmbp:drive", ["%s: the load counts the inertia and friction that %s %s " ...
                               "has: set them to 0 with gsmbp_set, or take an ideal source " ...
                               "(word drive)"], who, entry, name);
    endif
  endfor
endfunction

## the column of tau and the number of the coordinate
function [column, k] = moved (who, m, name)
  list = (1:m.sizes.nu)';
  if (m.sizes.nlam > 0)
    list = m.actuated(:);
  endif
  names = m.coordinates(list)(:)';
  if (isempty (name))
    if (numel (list) != 1)
      error ("%s: argument name: expected one of the coordinates %s, found nothing", who, ...
             strjoin (names, ", "));
    endif
    [column, k] = deal (1, list);
    return;
  endif
  gs.given.check_kind (who, "argument name", name{1}, "text");
  column = find (strcmp (names, name{1}));
  if (isempty (column))
    error ("%s: argument name: unknown coordinate %s", who, gs.text.nearest_word (name{1}, names));
  endif
  k = list(column);
endfunction

function c = along (who, m, r, column, k)
  d = m.sizes;
  nt = numel (r.t);
  c.t = r.t(:);
  [q, u] = deal (r.x(:,1:d.nq), r.x(:,d.nq+(1:d.nu)));
  if (isfield (r, "tau"))
    [ud, tau] = deal (r.ud, r.tau(:,column));
  else
    [ud, tau] = deal (zeros (nt, d.nu), zeros (nt, 1));
    given = others (m);
    for i = 1:nt
      ud(i,:) = m.rhs (r.t(i), r.x(i,:)', r.v(i,:)')(d.nq+(1:d.nu));
      tau(i) = effort (m, r.t(i), q(i,:)', u(i,:)', ud(i,:)', given .* r.v(i,:)')(column);
    endfor
  endif
  [c.position, c.omega, c.alpha, c.torque] = deal (q(:,k), u(:,k), ud(:,k), tau);
  if (! all (isfinite ([c.omega; c.alpha; c.torque])))
    error ("%s: %s: speed, acceleration or effort is not finite", who, m.coordinates{k});
  endif
  c.inertia = largest_inertia (m, c.t, q, u, k);
  c.unit = {"rad", "m"}{1 + strncmp(m.units.coordinates{k}, "m", 1)};
endfunction

## inputs that are not the efforts of ideal sources: 1, else 0
function given = others (m)
  given = ones (m.sizes.nv, 1);
  for d = gs.model.json_rows (m.json, "devices")
    if (strcmp (d{1}.entry, "drive"))
      given(strncmp (m.inputs, [d{1}.name "."], numel (d{1}.name) + 1)) = 0;
    endif
  endfor
endfunction

function tau = effort (m, t, q, u, ud, v)
  if (m.sizes.nlam > 0)
    tau = m.inl (t, q, u, ud, v);
  else
    tau = m.inv (t, q, u, ud, v);
  endif
endfunction

## largest inertia on the coordinate, at fifty of the times; NaN where no subroutine tells it
function most = largest_inertia (m, t, q, u, k)
  most = NaN;
  some = unique (round (linspace (1, numel (t), min (numel (t), 50))));
  loops = m.sizes.nlam > 0;
  if (loops && ! any (strcmp (m.subroutines, "con")) || ! any (strcmp (m.subroutines, "mas")))
    return;
  endif
  for i = some
    if (loops)
      one = gsmbp_reduced (m, t(i), q(i,:)', u(i,:)', m.coordinates(m.actuated)).M;
      one = one(m.actuated == k, m.actuated == k);
    else
      one = m.mas (t(i), q(i,:)')(k,k);
    endif
    most = max (most, one);
  endfor
endfunction

%!shared m
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("hand_crank");
%!test <a plan, through a loop: the inertia follows from the energy>
%! plan = gsmbp_plan ("quintic", [0.3 2], [0 1]);
%! r = gsmbp_inverse (m, plan, 0:0.05:1);
%! c = gsmbp_cycle (m, r, "q1");
%! assert ([c.omega, c.alpha, c.torque], [r.u(:,1), r.ud(:,1), r.tau]);
%! e = m.ene (0, [r.q(11,:), r.u(11,:)]')(1);
%! one = gsmbp_cycle (m, gsmbp_inverse (m, plan, 0.5));
%! assert (one.inertia, 2 * e / r.u(11,1) ^ 2, 1e-12);
%!test <a motor in the scene would count twice>
%! n = m;
%! n.json.devices = struct ("name", "M", "entry", "dc_motor");
%! n.par.M_J = n.applied.M_J = 1e-4;
%! r = struct ("t", 0, "x", 0, "v", 0);
%! fail ("gsmbp_cycle (n, r)", "counts M_J = 0.0001 of dc_motor M");
%!test <a table>
%! c = gsmbp_cycle ([0 1 2 3; 1 4 5 6], "unit", "m", "inertia", 7);
%! assert ({c.t, c.omega, c.alpha, c.torque, c.unit, c.inertia}, ...
%!         {[0; 1], [1; 4], [2; 5], [3; 6], "m", 7});
%!error <unknown coordinate "shaft"; known: q1>
%! gsmbp_cycle (m, struct ("t", 0, "x", 0, "v", 0), "shaft")
%!error <expected a row of time, speed, acceleration and torque> gsmbp_cycle ([0 1 2])
%!error <found Inf in row 2, column 3> gsmbp_cycle ([0 1 2 3; 1 4 Inf 6])
%!error <strictly increasing> gsmbp_cycle ([0 1 2 3; 0 4 5 6])
%!error <expected a struct with the fields t, x, v, found 3> gsmbp_cycle (m, 3)
