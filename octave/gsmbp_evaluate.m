## -*- texinfo -*-
## @c category Motions
## @deftypefn  {} {@var{f} =} gsmbp_evaluate (@var{motion}, @var{times})
## @deftypefnx {} {@var{f} =} gsmbp_evaluate (@var{motion}, @var{times}, @var{nd}, @var{side})
## Values and derivatives of a piecewise polynomial, as GSPLN of the Fortran
## run time gives them.
##
## @var{f}(@var{i},@var{j},@var{d}+1) is derivative @var{d} (0 to @var{nd},
## default 0) of component @var{i} at @var{times}(@var{j}).  @var{side}
## (default 1) tells which limit to take at a break: -1 from the left, 1 from
## the right.  Before the first and after the last break the value is held and
## the derivatives are zero.
##
## @c session octave
## @example
## >> plan = gsmbp_plan ("quintic", [0 1], [0 2]);
## >> f = gsmbp_evaluate (plan, [0 1 2], 2);
## >> squeeze (f)
## ans =
##
##         0        0        0
##    0.5000   0.9375        0
##    1.0000        0        0
## @end example
##
## Errors: a motion that is no piecewise polynomial; times, nd or side that
## are no such numbers.
## Source: own; Horner's scheme.
## @seealso{gsmbp_plan, ppval}
## @end deftypefn

function f = gsmbp_evaluate (motion, times, nd = 0, side = 1)
  if (nargin < 2)
    print_usage ();
  endif
  motion = gs.given.given_polynomial ("gsmbp_evaluate", motion);
  gs.given.check_kind ("gsmbp_evaluate", "argument times", times, "numbers");
  gs.given.check_kind ("gsmbp_evaluate", "argument nd", nd, "whole");
  gs.given.check_kind ("gsmbp_evaluate", "argument side", side, "number");
  [times, nd, side] = deal (double (times), double (nd), double (side));
  n = prod (motion.dim);
  k = motion.order;
  breaks = motion.breaks;
  tol = 1e-12 * (breaks(end) - breaks(1));
  times = times(:)';
  inside = min (max (times, breaks(1)), breaks(end));
  if (side < 0)
    piece = sum (inside(:)' > breaks(2:end)(:), 1) + 1;
  else
    piece = sum (inside(:)' >= breaks(2:end)(:), 1) + 1;
  endif
  piece = min (piece, motion.pieces);
  outside = times < breaks(1) - tol | times > breaks(end) + tol;
  near = ! outside;
  inside(near) = times(near);
  s = inside - breaks(piece);
  c = reshape (motion.coefs, n, motion.pieces, k);
  f = zeros (n, numel (times), nd + 1);
  p = c(:,piece,:);
  for d = 0:min (nd, k - 1)
    value = p(:,:,1);
    for e = 2:k-d
      value = value .* s + p(:,:,e);
    endfor
    f(:,:,d+1) = value;
    p = p(:,:,1:end-1) .* reshape (k-d-1:-1:1, 1, 1, []);
  endfor
  f(:,outside,2:end) = 0;
endfunction

%!test
%! p = mkpp ([0 1 2], [1 0 0; 0 2 1]);
%! assert (gsmbp_evaluate (p, [0.5 1.5], 2), cat (3, [0.25 2], [1 2], [2 0]));
%! assert (gsmbp_evaluate (p, 1, 1, -1)(:)', [1 2]);
%! assert (gsmbp_evaluate (p, [-1 3], 1), cat (3, [0 3], [0 0]));
%!error <expected a piecewise polynomial> gsmbp_evaluate (1, 2)
