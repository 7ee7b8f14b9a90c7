## Q = pose_effort (PLACE, BODY, GRAVITY, TH, W, ALPHA): the force on the coordinate th that bodies
## need to move on the poses PLACE (th) with speed W and acceleration ALPHA: I th'' + I' th'^2 / 2 +
## V', where I is pose_metric and V the potential of gravity.

function Q = pose_effort (place, body, gravity, th, w, alpha)
  I = @(th) pose_metric (place, body, th);
  V = @(th) -gravity' * pose_centres (place (th), body) * [body.mass]';
  Q = I (th) * alpha + pose_slope (I, th) * w ^ 2 / 2 + pose_slope (V, th);
end
