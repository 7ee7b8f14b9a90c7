## d = gs.optimize.weights_slope (t)
## How the weights of an integral over the times T (gs.optimize.integral_weights), a column, change
## with the last time: differences of order 4.

function d = weights_slope (t)
  h = 1e-3 * (t(end) - t(end-1));
  w = @(s) gs.optimize.integral_weights ([t(1:end-1); t(end) + s * h]);
  d = (8 * (w (1) - w (-1)) - (w (2) - w (-2))) / (12 * h);
endfunction
