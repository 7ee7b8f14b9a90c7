## -*- texinfo -*-
## @c category Positions and equilibria
## @deftypefn  {} {@var{x} =} gsmbp_assemble (@var{m}, @var{guess})
## @deftypefnx {} {@var{x} =} gsmbp_assemble (@dots{}, "hold", @var{names}, "time", @var{t})
## @deftypefnx {} {@var{x} =} gsmbp_assemble (@dots{}, "tolerance", @var{tol})
## @deftypefnx {} {@var{X} =} gsmbp_assemble (@var{m}, @var{guess}, "branches", @var{n}, @dots{})
## A state of the scene that fulfils its constraints, from a rough one.
##
## @var{guess} are the @var{nx} states (or the @var{nq} coordinates alone; the
## speeds are then zero); the result is a column.  Coordinates and speeds are
## moved as little as possible in the metric of the mass matrix (subroutine
## PRJ), or, where "hold" names some of the coordinates, the named ones and
## the speeds that move them stay as they are and the others follow on the
## branch of the guess: the loops are closed near the guess first (the held
## coordinates go where the others fit best), then the held coordinates are
## moved to their values in small steps.  Euler parameters are normalized; of a
## set all four may be held (the orientation) or none.  @var{t} is the time, 0
## by default.
##
## States of devices that the guess does not hold are as in @code{m.initial}; filters
## and observers that are settled in the guess are settled in the result.
##
## If the loop does not close it is an error that says by how much it fails:
## the largest |phi| that is left, above @var{tol} (default 1e-10, in the
## unit of the constraint).  It is an error, too, if only another branch reaches
## the values of the held coordinates.
##
## A position where the constraints lose rank (a change point; all links in one
## line, because degrees were typed for radians) is a warning.  So is a held coordinate outside the
## limits of its joint (@code{gsmbp:limits}): limits are not enforced.
##
## With "branches" the guess and @var{n} more around it are tried (angles up to
## half a turn away, lengths by the size of the mechanism, any orientation; the
## same ones at every call), and all the different states that were found
## come back as columns of @var{X}, the nearest to the guess first.  Hold the
## independent coordinates: otherwise every guess finds another place of the
## same motion.  It is an error if none of them closes the loop.
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> x = gsmbp_assemble (m, [1; -1; 0.6], "hold", "q1");
## >> x(1:3)'
## ans =
##
##    1.0000  -1.3433   0.5789
## >> X = gsmbp_assemble (m, [1; -1; 0.6], "hold", "q1", "branches", 20);
## >> X(1:3,:)
## ans =
##
##    1.0000   1.0000
##   -1.3433  -3.7983
##    0.5789  -0.3628
## @end example
##
## Errors: a loop that does not close, or a guess that no branch closes; a
## coordinate in "hold" that the model has not, that a motion drives, that other held ones
## determine, with a value that no branch reaches (named is the last one that is), or one alone
## of four Euler parameters; a guess of another size, not finite, or with zeros for Euler
## parameters.
## Source: own: projection in the metric of the mass matrix (PRJ); with "hold"
## numerical continuation (Allgower and Georg 1990, chapter 6).
## @seealso{gsmbp_simulate}
## @end deftypefn

function x = gsmbp_assemble (m, guess, varargin)
  if (nargin < 2)
    print_usage ();
  endif
  who = "gsmbp_assemble";
  gs.given.check_model (who, m);
  gs.given.refuse_words (who, "guess", guess);
  table = {"hold", {}, "names"
           "time", 0, "number"
           "tolerance", 1e-10, "positive"
           "branches", 0, "whole"};
  o = gs.given.call_options (who, table, varargin);
  x = guessed (who, m, guess);
  settled = isequal (numel (guess), m.sizes.nq) || is_settled (m, o.time, x);
  held = held_coordinates (who, m, o.hold);
  whole_orientations (who, m, held);
  if (m.sizes.nlam == 0)
    if (m.sizes.nq > m.sizes.nu)
      x = gs.start.unit_orientations (m, x);
    endif
  elseif (o.branches == 0)
    [x, complaint, other] = gs.start.close_loops (m, x, o, held);
    complaint = [complaint, other(1:end*isempty (complaint))];
    if (! isempty (complaint))
      error ("%s: %s: %s", who, m.name, complaint);
    endif
  else
    x = branches (who, m, x, o, held);
  endif
  warn_of_limits (who, m, x(:,1), held);
  for k = 1:columns (x)
    warn_of_lost_rank (who, m, o.time, x(:,k));
  endfor
  if (settled)
    for k = 1:columns (x)
      x(:,k) = gs.start.settled_state (m, o.time, x(:,k));
    endfor
  endif
endfunction

function warn_of_limits (who, m, x, held)
  limits = gs.model.scene_limits (m, m.coordinates);
  for k = find (held)'
    if (! (limits(k,1) <= x(k) && x(k) <= limits(k,2)))
      warning ("gsmbp:limits", ["%s: %s: option hold: %s = %.6g %s is outside the limits of " ...
                                "its joint; expected %.6g to %.6g"], who, m.name, ...
               m.coordinates{k}, x(k), m.units.coordinates{k}, limits(k,:));
    endif
  endfor
endfunction

function warn_of_lost_rank (who, m, t, x)
  [rows, rank] = gs.start.lost_rank (m, t, x);
  if (! isempty (rows))
    warning ("gsmbp:singular", ["%s: %s: at the position found %d of the %d constraints that " ...
                                "are independent elsewhere are so, lost in rows %s: a " ...
                                "change point, or links in one line; is it meant? " ...
                                "(angles are in rad)"], ...
             who, m.name, rank, m.mobility.rank, strjoin (rows, ", "));
  endif
endfunction

## filters of sensors and observers are where their rates vanish
function yes = is_settled (m, t, x)
  y = gs.start.settled_state (m, t, x);
  yes = all (abs (y - x) <= 1e-9 * (m.nominal + abs (x)));
endfunction

function x = guessed (who, m, guess)
  d = m.sizes;
  x = gs.given.given_guess (who, m, "guess", guess, m.initial(d.nq + 1:d.nx));
  for set = m.orientation'
    if (! any (x(set)))
      error (["%s: %s: expected a guess of the Euler parameters (%s), found zeros, which " ...
              "are no orientation"], who, m.name, strjoin (m.coordinates(set)', ", "));
    endif
  endfor
endfunction

## one Euler parameter cannot stay while the orientation changes: each speed moves all four
function whole_orientations (who, m, held)
  for set = m.orientation'
    if (any (held(set)) && ! all (held(set)))
      error (["%s: %s: option hold: %s is one of the Euler parameters (%s) of one orientation: " ...
              "hold all four, or none (one alone would freeze the orientation)"], who, m.name,
             m.coordinates{set(find (held(set), 1))}, strjoin (m.coordinates(set)', ", "));
    endif
  endfor
endfunction

function held = held_coordinates (who, m, names)
  held = false (m.sizes.nq, 1);
  for name = cellstr (names)(:)'
    if (isempty (name{1}))
      continue;
    endif
    k = strcmp (m.coordinates, name{1});
    if (! any (k))
      error ("%s: option hold: %s has no coordinate %s", who, m.name,
             gs.text.nearest_word (name{1}, m.coordinates));
    endif
    held |= k(:);
  endfor
endfunction

## all different states from many guesses, as columns
function found = branches (who, m, guess, o, held)
  before = rand ("twister");
  unwind_protect
    rand ("twister", 7);
    guesses = [guess, around(m, guess, held, o.branches)];
  unwind_protect_cleanup
    rand ("twister", before);
  end_unwind_protect
  found = zeros (numel (guess), 0);
  first = "";
  for k = 1:columns (guesses)
    try
      [x, complaint] = gs.start.close_loops (m, guesses(:,k), o, held, k > 1);
    catch err
      complaint = err.message;
    end_try_catch
    if (isempty (complaint))
      x = wound (m, x, guess);
      if (isempty (found) ...
            || all (max (abs (difference (m, found, x)), [], 1) > 1e-6 ...
                      * max (1, norm (x(1:m.sizes.nq), Inf))))
        found(:,end+1) = x;
      endif
    elseif (isempty (first))
      first = complaint;
    endif
  endfor
  if (isempty (found))
    error ("%s: %s: none of %d guesses: %s", who, m.name, columns (guesses), first);
  endif
  [~, order] = sort (max (abs (difference (m, found, guess)), [], 1));
  found = found(:,order);
endfunction

## N guesses: angles by up to half a turn, lengths by up to the largest one, orientations at random
function guesses = around (m, guess, held, n)
  d = m.sizes;
  unit = m.units.coordinates;
  size = pi * ones (d.nq, 1);
  long = ! strcmp (unit, "rad") & ! euler (m);
  lengths = struct2cell (m.par)(strcmp (m.units.parameters, "m"));
  size(long) = max ([1e-3; abs(guess(long)); abs([lengths{:}]')]);
  size(held) = 0;
  guesses = repmat (guess, 1, n);
  guesses(1:d.nq,:) += size .* (2 * rand (d.nq, n) - 1);
  for set = m.orientation'
    if (! any (held(set)))
      e = sqrt (-2 * log (rand (4, n))) .* cos (2 * pi * rand (4, n));
      guesses(set,:) = e ./ sqrt (sumsq (e, 1));
    endif
  endfor
endfunction

function yes = euler (m)
  yes = false (m.sizes.nq, 1);
  yes(m.orientation(:)) = true;
endfunction

## angles within half a turn of the guess, the sign of Euler parameters as there
function x = wound (m, x, guess)
  turning = find (strcmp (m.units.coordinates, "rad") & ! euler (m));
  x(turning) -= 2 * pi * round ((x(turning) - guess(turning)) / (2 * pi));
  for set = m.orientation'
    if (x(set)' * guess(set) < 0)
      x(set) *= -1;
    endif
  endfor
endfunction

## coordinates of the columns of FOUND less those of X, turns and signs aside
function e = difference (m, found, x)
  e = found(1:m.sizes.nq,:) - x(1:m.sizes.nq);
  turning = strcmp (m.units.coordinates, "rad") & ! euler (m);
  e(turning,:) -= 2 * pi * round (e(turning,:) / (2 * pi));
  for set = m.orientation'
    other = found(set,:) + x(set);
    swap = max (abs (other), [], 1) < max (abs (e(set,:)), [], 1);
    e(set,swap) = other(:,swap);
  endfor
endfunction

%!shared c
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
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
%!test <both branches of the slider-crank>
%! x = gsmbp_assemble (c, [0.3 -0.1 0.7 12 0 0], "hold", "q1", "branches", 20);
%! assert (x(1,:), [0.3 0.3]);
%! assert (x(3,:), 0.2 * cos (0.3) + [1 -1] * sqrt (0.25 - 0.04 * sin (0.3)^2), 1e-14);
%!error <none of 6 guesses: option hold: expected q1 at least 2.618, .* do not close$>
%! gsmbp_assemble (gsmbp_set (c, "l2", 0.1), [pi/2 0 0], "hold", "q1", "branches", 5)
%!error <option hold: expected q1 at least 2.618, where the branch .*; other branches: option>
%! gsmbp_assemble (gsmbp_set (c, "l2", 0.1), [pi/2 0 0], "hold", "q1")
%!error <has no coordinate "q9"> gsmbp_assemble (c, [0.3 -0.1 0.7], "hold", "q9")
%!error <argument guess: expected 6 numbers .*, found 1x2>
%! gsmbp_assemble (c, [0.3 -0.1])
