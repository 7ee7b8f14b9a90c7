## K = gs.plan.cross_matrix (r)
## The matrix of the cross product: K*x = r x X for any X; R is a column or a row of three.

function K = cross_matrix (r)
  K = [0, -r(3), r(2); r(3), 0, -r(1); -r(2), r(1), 0];
endfunction
