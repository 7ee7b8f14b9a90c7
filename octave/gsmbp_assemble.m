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
  d = m.sizes;
  x = gs.given.given_guess (who, m, "guess", guess, m.initial(d.nq + 1:d.nx));
  [x, why, beyond, lost] = m.module ("assemble", m.cst, gs.model.parameter_values (m), o.time, ...
                                     x, m.nominal, held_coordinates (who, m, o.hold), ...
                                     o.branches, longest (m), o.tolerance, ...
                                     numel (guess) == d.nq, gs.start.general_rank (m), ...
                                     gs.model.scene_limits (m, m.coordinates), m.initial);
  if (isempty (x))
    error ("%s: %s: %s", who, m.name, why);
  endif
  for one = {"limits", beyond; "singular", lost}'
    if (! isempty (one{2}))
      warning (["gsmbp:" one{1}], "%s: %s: %s", who, m.name, one{2});
    endif
  endfor
endfunction

function held = held_coordinates (who, m, names)
  held = zeros (m.sizes.nq, 1);
  for name = cellstr (names)(:)'
    if (isempty (name{1}))
      continue;
    endif
    k = strcmp (m.coordinates, name{1});
    if (! any (k))
      error ("%s: option hold: %s has no coordinate %s", who, m.name,
             gs.text.nearest_word (name{1}, m.coordinates));
    endif
    held(k) = 1;
  endfor
endfunction

## the largest parameter that is a length [m]
function size = longest (m)
  lengths = struct2cell (m.par)(strcmp (m.units.parameters, "m"));
  size = max ([0; abs([lengths{:}]')]);
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
