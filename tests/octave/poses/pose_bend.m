## D = pose_bend (F, X): second derivative, as pose_slope; good to 1e-12 of F.

function d = pose_bend (f, x)
  h = 0.02;
  weights = [8/5, -1/5, 8/315, -1/560] / h ^ 2;
  d = -205/72 / h ^ 2 * f (x);
  for k = 1:4
    d += weights(k) * (f (x + k * h) + f (x - k * h));
  end
end
