## D = gs.optimize.value_slope (f, variable, at)
## The derivative of f (value), an array or a struct of arrays, by a free variable (its scale, low
## and high) at the value AT: differences of order 4 within its bounds, from one side at a bound.

function D = value_slope (f, variable, at)
  h = 1e-3 * variable.scale;
  up = (variable.high - at) / 2;
  down = (at - variable.low) / 2;
  if (min (up, down) >= h / 100)
    h = min ([h, up, down]);
    D = combined ({f(at + 2 * h), f(at + h), f(at - h), f(at - 2 * h)}, [-1 8 -8 1] / (12 * h));
  else
    h = merge (up > down, 1, -1) * min (h, max (up, down) / 2);
    D = combined ({f(at), f(at + h), f(at + 2 * h), f(at + 3 * h), f(at + 4 * h)}, ...
                  [-25 48 -36 16 -3] / (12 * h));
  endif
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
