## D = gs.optimize.value_slope (P, k, f, at)
## The derivative of f (value), an array or a struct of arrays, by free variable K of the design P
## at the value AT: differences of order 4 within its bounds, from one side at a bound.

function D = value_slope (P, k, f, at)
  v = P.free(k);
  [points, factors] = P.base.module ("differences", v.start, v.low, v.high, at);
  D = combined (arrayfun (f, points, "UniformOutput", false), factors);
endfunction

## less the first value: of numbers that do not change exactly 0
function D = combined (values, weights)
  D = values{1};
  if (isstruct (D))
    for name = fieldnames (D)'
      parts = cellfun (@(v) v.(name{1}), values, "UniformOutput", false);
      D.(name{1}) = combined (parts, weights);
    endfor
  else
    first = D;
    D = zeros (size (first));
    for k = 2:numel (values)
      D += weights(k) * (values{k} - first);
    endfor
  endif
endfunction
