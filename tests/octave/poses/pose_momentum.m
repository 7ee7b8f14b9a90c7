## L = pose_momentum (PLACE, BODY, TH): angular momenta about the mass centres (a column for each
## body) of the poses PLACE (th) for a rate of 1.

function L = pose_momentum (place, body, th)
  T = place (th);
  w = pose_spin (place, th);
  for k = 1:numel (body)
    R = T(1:3, 1:3, k);
    L(:, k) = R * body(k).inertia * R' * w(:, k);
  end
end
