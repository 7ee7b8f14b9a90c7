## -*- texinfo -*-
## @c category Positions and equilibria
## @deftypefn  {} {@var{r} =} gsmbp_reduced (@var{m}, @var{t}, @var{q}, @var{u}, @var{names})
## @deftypefnx {} {@var{r} =} gsmbp_reduced (@dots{}, @var{names}, @var{v})
## Equations of motion of a closed chain in independent coordinates of your choice.
##
## @var{names} are as many of the coordinates of the model @var{m} as it has freedoms (a text or a
## cell array), those of a platform for instance; w are their speeds.  @var{q} are closed
## coordinates and @var{u} speeds that fulfil the constraints (@code{gsmbp_assemble}),
## @var{v} the inputs (0 by default), @var{t} the time [s].  @var{r} has the fields
##
## @table @code
## @item T, c
## @code{ud = T*wd + c}, and @code{u = T*w} where time does not move the constraints
## @item M, bias
## mass matrix and bias: @code{M*wd + bias} are the efforts on w, less passive and given forces
## @item gravity
## what gravity adds to @code{bias}; where the request @code{gravity} was emitted
## @item independent
## numbers of the speeds w
## @end table
##
## The same with a choice that is made when the scene is derived, compiled: the handles
## @code{m.ind}, @code{m.red}, @code{m.jpi} (requests @code{independent}, @code{reduced},
## @code{independent_jacobians} of @code{gsmbp_fortran}).
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> x = gsmbp_assemble (m, m.initial);
## >> q = x(1:3);
## >> [~, ~, H] = m.con (0, q, zeros (3, 1));
## >> u = null (H);
## >> r = gsmbp_reduced (m, 0, q, u / u(1), "q1");
## >> r.M, r.T'
## ans = 0.1200
## ans =
##
##    1.0000  -1.4000        0
## @end example
##
## Errors: coordinates from which the motion of the others does not follow, an unknown
## coordinate, a position of another size.
## Source: own; the projection of Kane's equations on independent speeds.
## @seealso{gsmbp_point, gsmbp_operational, gsmbp_assemble}
## @end deftypefn

function r = gsmbp_reduced (m, t, q, u, names, v = [])
  if (nargin < 5)
    print_usage ();
  endif
  who = "gsmbp_reduced";
  gs.given.check_model (who, m);
  gs.given.check_moving (who, m);
  gs.given.check_kind (who, "argument names", names, "names");
  u = gs.given.given_vector (who, "u", u, m.sizes.nu, "", m.speeds);
  [r.T, r.c, r.independent] = gs.linear.independent_speeds (who, "argument names", m, t, q, u, ...
                                                            names);
  M = m.mas (t, q);
  r.M = r.T' * M * r.T;
  r.M = (r.M + r.M') / 2;
  r.bias = r.T' * (m.bia (t, q, u, v) + M * r.c);
  if (any (strcmp ("gra", m.subroutines)))
    r.gravity = r.T' * m.gra (t, q);
  endif
endfunction

%!error <Invalid call> gsmbp_reduced (1, 2)
