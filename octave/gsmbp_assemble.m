## -*- texinfo -*-
## @deftypefn  {} {@var{x} =} gsmbp_assemble (@var{m}, @var{guess})
## @deftypefnx {} {@var{x} =} gsmbp_assemble (@var{m}, @var{guess}, "hold", @var{names}, "time", @var{t}, "tolerance", @var{tol})
## A state of the scene that fulfils its constraints, from a rough one.
##
## @var{guess} are the @var{nx} states (or the @var{nq} coordinates alone; the
## speeds are then zero); the result is a column.  Coordinates and speeds are
## moved as little as possible in the metric of the mass matrix (subroutine
## PRJ), or, where "hold" names some of the coordinates, the named ones and
## their speeds stay as they are and the others follow by Newton's method.
## @var{t} is the time, 0 by default.
##
## If the loop does not close it is an error that says by how much it fails:
## the largest |phi| that is left, above @var{tol} (default 1e-10, in the
## unit of the constraint).
## @seealso{gsmbp_simulate}
## @end deftypefn

function x = gsmbp_assemble (m, guess, varargin)
  if (nargin < 2 || ! isstruct (m))
    print_usage ();
  endif
  who = "gsmbp_assemble";
  o = gsmbp__options (who, struct ("hold", {{}}, "time", 0, "tolerance", 1e-10), varargin);
  d = m.sizes;
  x = double (guess(:));
  if (numel (x) == d.nq)
    x = [x; zeros(d.nx - d.nq, 1)];
  elseif (numel (x) != d.nx)
    error ("%s: %s: expected a guess of %d states or %d coordinates, found %d numbers", who, m.name, d.nx, d.nq, numel (x));
  endif
  if (! all (isfinite (x)))
    error ("%s: %s: the guess of %s is not finite", who, m.name, m.states{find(! isfinite (x), 1)});
  endif
  if (d.nlam == 0)
    return;
  endif
  if (isempty (o.hold))
    [x, ~, info] = m.prj (o.time, x);
  else
    x = solve (who, m, x, o);
  endif
  q = x(1:d.nq);
  u = x(d.nq + (1:d.nu));
  if (all (isfinite (x)))
    [phi, phit, H, ~, ~] = m.con (o.time, q, u);
    rate = H * u + phit;
  else
    phi = rate = Inf (d.nlam, 1);
  endif
  [gap, k] = max (abs (phi));
  if (! (gap <= o.tolerance))
    error ("%s: %s: the loop does not close: %s = %.6g is left of the constraints (tolerance %g); try another guess or check the lengths", who, m.name,
           label (m, k), phi(k), o.tolerance);
  endif
  [gap, k] = max (abs (rate));
  if (! (gap <= o.tolerance * max (1, norm (u))))
    error ("%s: %s: the speeds do not fit the constraints: the rate of %s is %.6g", who, m.name, label (m, k), rate(k));
  endif
endfunction

## Newton on the coordinates that are not held, then their speeds
function x = solve (who, m, x, o)
  d = m.sizes;
  held = cellstr (o.hold);
  free = true (1, d.nq);
  for i = 1:numel (held)
    k = strcmp (m.coordinates, held{i});
    if (! any (k))
      error ("%s: %s has no coordinate \"%s\"; it has %s", who, m.name, held{i}, strjoin (m.coordinates', ", "));
    endif
    free(k) = false;
  endfor
  free = find (free);
  u = x(d.nq + (1:d.nu));
  least = Inf;
  for iteration = 1:50
    q = x(1:d.nq);
    [phi, ~, H, ~, ~] = m.con (o.time, q, u);
    if (norm (phi, Inf) < least)
      least = norm (phi, Inf);
      best = x;
    endif
    step = -pinv (H(:,free)) * phi;
    limit = max (1, max (abs (step)));
    x(free) += step / limit;
    if (norm (step, Inf) <= 1e-15 * max (1, norm (q, Inf)) || norm (phi, Inf) == 0)
      break;
    endif
  endfor
  if (norm (m.con (o.time, x(1:d.nq), u), Inf) > least)
    x = best;
  endif
  [~, phit, H, ~, ~] = m.con (o.time, x(1:d.nq), u);
  u(free) -= pinv (H(:,free)) * (H * u + phit);
  x(d.nq + (1:d.nu)) = u;
endfunction

function text = label (m, k)
  text = sprintf ("phi(%d)", k);
  if (numel (m.multipliers) >= k)
    text = sprintf ("phi of %s", m.multipliers{k});
  endif
endfunction

%!shared c
%! addpath (fullfile (fileparts (fileparts (which ("gsmbp_build"))), "tests", "octave"));
%! c = gsmbp_hand ("hand_crank");
%!test
%! x = gsmbp_assemble (c, [0.3 -0.1 0.7 12 0 0]);
%! [phi, phit, H] = c.con (0, x(1:3), x(4:6));
%! assert (phi, [0; 0], 1e-14);
%! assert (H * x(4:6), [0; 0], 1e-12);
%!test <hold>
%! x = gsmbp_assemble (c, [0.3 -0.1 0.7 12 0 0], "hold", "q1");
%! assert (x([1 4]), [0.3; 12]);
%! assert (x(2), asin (-0.2 * sin (0.3) / 0.5), 1e-14);
%!error <loop does not close: phi of C\.y = 0.1[0-9]* is left> gsmbp_assemble (gsmbp_set (c, "l2", 0.1), [pi/2 0 0], "hold", "q1")
%!error <has no coordinate "q9"> gsmbp_assemble (c, [0.3 -0.1 0.7], "hold", "q9")
%!error <expected a guess of 6 states or 3> gsmbp_assemble (c, [0.3 -0.1])
