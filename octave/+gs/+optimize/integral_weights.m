## w = gs.optimize.integral_weights (t)
## The weights of an integral over the times T, a column: of the cubic spline that has no knot in
## the second time and the last but one, if none is negative, else of straight lines.

function w = integral_weights (t)
  n = numel (t);
  h = diff (t);
  w = ([h; 0] + [0; h]) / 2;
  if (n >= 4)
    ## less what the second derivatives c of the spline take: A*c = B*y, of y the values
    A = spdiags ([[h(1:end-1); 0; 0], 2 * ([h; 0] + [0; h]), [0; 0; h(2:end)]], -1:1, n, n);
    A(1,1:3) = [h(2), -h(1) - h(2), h(1)];
    A(n,n-2:n) = [h(end), -h(end-1) - h(end), h(end-1)];
    s = 6 ./ h;
    B = spdiags ([[s(1:end-1); 0; 0], -[s; 0] - [0; s], [0; 0; s(2:end)]], -1:1, n, n);
    B([1, n],:) = 0;
    smooth = w - B' * (A' \ (([h; 0] .^ 3 + [0; h] .^ 3) / 24));
    if (all (smooth > 0))
      w = smooth;
    endif
  endif
endfunction
