## [x, start] = gsmbp__start (who, m, t, x, wanted)
## The state X of the model M at the time T [s] as every calculation takes it: on
## the constraints, with Euler parameters of length one.  WANTED: "check", an error
## of WHO that names rows and residuals where one is above 1e-6 (scaled by m.nominal);
## "project", moved onto the constraints (subroutine PRJ) from wherever it is.
## A state outside a margin of a device (gsmbp__margins) is an error of "check", too.
## START: a struct, see the help of gsmbp_simulate.

function [x, start] = gsmbp__start (who, m, t, x, wanted)
  d = m.sizes;
  argument = {"x", "x0"}{1 + any(strcmp (who, {"gsmbp_simulate", "gsmbp_ensemble", ...
                                                "gsmbp_sweep", "gsmbp_workprecision"}))};
  x = gsmbp__vector (who, argument, x, d.nx, sprintf (" (the states of %s)", m.name),
                     m.states);
  no_lost_angle (who, argument, m, x);
  start = struct ("residual", 0, "row", "", "moved", 0, "state", "");
  check = strcmp (wanted, "check");
  if (d.nlam > 0 || d.nq != d.nu)
    [x, start] = closed (who, m, t, x, check, start);
  endif
  if (check)
    within_margins (who, m, t, x);
  endif
endfunction

function within_margins (who, m, t, x)
  list = gsmbp__margins (m, t, x', zeros (1, m.sizes.nv));
  if (! isempty (list))
    error ("gsmbp:start",
           "%s: %s: %s; \"start\", \"project\" takes devices as they are",
           who, m.name, gsmbp__refusal ("device", strjoin ({list.said}, "; ")));
  endif
endfunction

## X on the constraints
function [x, start] = closed (who, m, t, x, check, start)
  d = m.sizes;
  no_zero_orientation (who, m, x);
  [names, scaled, found] = gsmbp__residuals (m, t, x);
  [start.residual, k] = max ([abs(scaled); 0]);
  start.row = [names; {""}]{k};
  if (check && ! (start.residual <= gsmbp__run_limit ("off_constraints")))
    refuse (who, m, t, ["found " worst(names, scaled, found)]);
  endif
  ## what is closed to rounding stays as it is
  seen = d.nlam == 0 || any (strcmp (m.subroutines, "con"));
  if (start.residual > 100 * eps || ! (check || seen))
    [x, start] = moved (who, m, t, x, check, start);
  endif
endfunction

function refuse (who, m, t, found)
  error ("gsmbp:start",
         "%s: %s: %s; close it by gsmbp_assemble, or have it moved: \"start\", \"project\"",
         who, m.name, gsmbp__refusal ("off_constraints", t, found));
endfunction

## an angle beyond 1e15 rad has lost its sine to rounding
function no_lost_angle (who, argument, m, x)
  k = find (strcmp (m.units.coordinates, "rad") & ...
            abs (x(1:m.sizes.nq)) > gsmbp__run_limit ("largest_angle"), 1);
  if (! isempty (k))
    error ("%s: argument %s(%d), %s: %s", who, argument, k, m.coordinates{k}, ...
           gsmbp__refusal ("largest_angle", x(k)));
  endif
endfunction

function no_zero_orientation (who, m, x)
  for set = m.orientation'
    if (! (norm (x(set)) > gsmbp__run_limit ("short_orientation")))
      error ("%s: %s: %s", who, m.name, ...
             gsmbp__refusal ("orientation", strjoin (m.coordinates(set)', ", "), ...
                             mat2str (x(set)', 6)));
    endif
  endfor
endfunction

## X on the constraints, and by how much it was moved
function [y, start] = moved (who, m, t, x, check, start)
  y = x;
  if (! any (strcmp (m.subroutines, "prj")))
    if (! check)
      error (["%s: \"start\", \"project\" needs the subroutine PRJ (request projection), " ...
              "which %s was emitted without"], who, m.name);
    endif
    return;
  endif
  [y, ~, info] = m.prj (t, x);
  on_them (who, m, t, y, info);
  [start.moved, k] = max (abs (y - x) ./ m.nominal);
  start.state = m.states{k};
  if (start.moved > gsmbp__run_limit ("moved_start") && check)
    refuse (who, m, t, sprintf (["found one that %s puts off them by %.3g only, but that must " ...
                                 "be moved by %.3g in %s (close to a singular position)"],
                                start.row, start.residual, start.moved, start.state));
  endif
endfunction

function on_them (who, m, t, y, info)
  scaled = NaN;
  names = {"a state that is not finite"};
  found = NaN;
  if (all (abs (y) <= 1e300))
    [names, scaled, found] = gsmbp__residuals (m, t, y);
  endif
  if (! all (abs (scaled) <= gsmbp__run_limit ("off_constraints")) || ! any (info == [0, 2]))
    error ("gsmbp:start",
           ["%s: %s: no state on the constraints was found near this one at t = %.9g s (%s); " ...
            "found %s; try gsmbp_assemble with another guess, or check the lengths"],
           who, m.name, t, gsmbp__info (m, "prj", info),
           worst (names, scaled, found));
  endif
endfunction

function text = worst (names, scaled, found)
  text = gsmbp__worst (names, scaled, found, gsmbp__run_limit ("off_constraints"));
endfunction
