## d = gs.identify.spline_derivatives (d, B, c)
## The data D with the motion whose coefficients C (a column for each coordinate) are those of the
## splines B: q, u, ud.

function d = spline_derivatives (d, B, c)
  [d.q, d.u, d.ud] = deal (B{1} * c, B{2} * c, B{3} * c);
endfunction
