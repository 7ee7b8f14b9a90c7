## -*- texinfo -*-
## @c category Positions and equilibria
## @deftypefn  {} {@var{q} =} gsmbp_reach (@var{m}, @var{name}, @var{P}, @var{R})
## @deftypefnx {} {[@var{q}, @var{info}] =} gsmbp_reach (@dots{}, @var{option}, @var{value})
## Coordinates that bring a point or frame of the scene to poses: inverse kinematics.
##
## @var{name} is a @code{point} or @code{frame} of the scene of the model @var{m}
## (@code{m.points}).  @var{P}, 3 x @var{k}, holds places [m] in ground axes, a column each, and
## @var{R} the axes there: 3 x 3 x @var{k} rotation matrices whose columns are the axes, or 4 x
## @var{k} Euler parameters, scalar first, or @code{[]}: the place alone is given (of a point
## always), for NIK where it is a frame's.  @var{q}, nq x @var{k}, are the coordinates, @code{NaN}
## where the pose is out of reach or beyond the limits.
##
## Where the subroutine IKN was emitted for @var{name} (request @code{inverse_kinematics}), all
## solutions are known, and the one closest to the pose before is taken (of the first pose the one
## closest to @qcode{"start"}); otherwise, and in closed chains, Newton's method goes on from there
## (NIK, request @code{reach}).
##
## Options:
## @table @code
## @item "start"
## coordinates from which the first pose is looked for (default: those of @code{m.initial})
## @item "branch"
## the number of a branch of IKN: solutions of this branch only
## @item "limits"
## nq x 2, least and largest value of every coordinate (default: the @code{limits} of the joints in
## the scene, at the values that its parameters had when it was derived); solutions beyond are left
## out, angles are taken with the turns that bring them within
## @item "method"
## @qcode{"auto"} (default), @qcode{"closed"}: IKN alone, @qcode{"newton"}: NIK alone
## @item "given"
## values of the coordinates that IKN was emitted to be given, a column for each pose or one for all
## @item "time"
## of constraints that depend on it [s], 0 by default
## @end table
##
## @var{info} has the fields @code{status}, a cell array of @qcode{"ok"}, @qcode{"singular"},
## @qcode{"unreachable"} or @qcode{"limits"} for each pose (singular: the least singular value of
## the Jacobian is at most 3e-8 of the largest, which is what rounding leaves of a double solution);
## @code{distance}, 2 x @var{k}: what an
## unreachable pose misses at the least, of the place [m] (of a wrist's centre where there is one)
## and of the axes; @code{branch}; @code{solutions}, a cell array with all solutions of each pose,
## a column each (IKN); and @code{free}, nu x @var{k}: speeds that do not move the tool where the
## pose is singular, else zeros.
##
## @c session octave
## @example
## >> gsmbp_derive ("examples/puma560/puma560.mac", "fortran_out");
## ...
## >> m = gsmbp_build ("puma560");
## >> [P, R] = m.pnt (0, [0.3; -0.2; 0.5]);
## >> [q, told] = gsmbp_reach (m, "wrist", P, R, "start", [0.2; 0; 0.4]);
## >> q'
## ans =
##
##    0.3000  -0.2000   0.5000
## >> told.status
## ans =
## @{
##   [1,1] = ok
## @}
##
## @end example
##
## Errors: no such point; poses of another size; axes that are no rotation; neither IKN nor NIK was
## emitted.
## Source: closed forms as @code{gsmbp_inverse_kinematics} of Maxima tells; Marquardt (1963).
## @seealso{gsmbp_point, gsmbp_assemble, gsmbp_plan}
## @end deftypefn

function [q, info] = gsmbp_reach (m, name, P, R = [], varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_reach";
  gs.given.check_model (who, m);
  gs.given.refuse_words (who, "P", P, "R", R);
  options = gs.given.call_options (who, {"start", [], "numbers"; "branch", 0, "whole"; ...
                                         "limits", [], "numbers"; ...
                                         "method", "auto", {"auto", "closed", "newton"}; ...
                                         "given", [], "numbers"; "time", 0, "number"}, varargin);
  turned = ! isempty (R);
  [P, R] = gs.plan.given_poses (who, m, P, R);
  job = gs.plan.reach_job (who, m, name, columns (P), turned, options);
  k = columns (P);
  q = NaN (m.sizes.nq, k);
  info = struct ("status", {cell(1, k)}, "distance", zeros (2, k), "branch", zeros (1, k), ...
                 "solutions", {cell(1, k)}, "free", zeros (m.sizes.nu, k));
  before = job.start;
  for i = 1:k
    one = gs.plan.reach_pose (who, m, job, P(:,i), R(:,:,i), i, before);
    q(:,i) = one.q;
    info.status{i} = one.status;
    info.distance(:,i) = one.distance;
    info.branch(i) = one.branch;
    info.solutions{i} = one.solutions;
    info.free(:,i) = one.free;
    if (all (isfinite (one.q)))
      before = one.q;
    endif
  endfor
endfunction

%!error <Invalid call> gsmbp_reach (1)
