## I = pose_metric (PLACE, BODY, TH): twice the kinetic energy of the bodies on the poses PLACE (th)
## for a rate of 1.

function I = pose_metric (place, body, th)
  v = pose_slope (@(th) pose_centres (place (th), body), th);
  I = [body.mass] * sumsq (v, 1)' ...
      + sum (pose_spin (place, th)(:, 1:numel (body)) .* pose_momentum (place, body, th))(:)' ...
      * ones (numel (body), 1);
end
