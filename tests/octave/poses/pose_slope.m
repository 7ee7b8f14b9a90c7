## D = pose_slope (F, X): derivative of F (values of any size) by its scalar argument: differences
## of eighth order, step 0.02; good to 1e-14 of F for functions that change over lengths of one.

function d = pose_slope (f, x)
  h = 0.02;
  weights = [4/5, -1/5, 4/105, -1/280] / h;
  d = 0;
  for k = 1:4
    d += weights(k) * (f (x + k * h) - f (x - k * h));
  end
end
