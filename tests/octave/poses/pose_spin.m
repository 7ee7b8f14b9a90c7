## W = pose_spin (PLACE, TH): angular velocities (a column for each body) of the poses PLACE (th)
## for a rate of 1.

function w = pose_spin (place, th)
  T = place (th);
  dT = pose_slope (place, th);
  for k = 1:size (T, 3)
    K = dT(1:3, 1:3, k) * T(1:3, 1:3, k)';
    w(:, k) = [K(3, 2) - K(2, 3); K(1, 3) - K(3, 1); K(2, 1) - K(1, 2)] / 2;
  end
end
