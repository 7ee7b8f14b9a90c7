## [T, k] = gs.linear.loop_tangent (who, m, t, x, wanted)
## The deviations that the constraints allow at the state X of the model M (host/linear/linear.h):
## T, whose columns change one independent state each, of the numbers k.  WANTED: the numbers of the
## states that are wanted as independent ones, [] where the Jacobian chooses.

function [T, k] = loop_tangent (who, m, t, x, wanted)
  at = gs.linear.state_place (m, t, x, zeros (m.sizes.nv, 1));
  [verdict, text, T, k] = m.module ("tangent", at{:}, wanted);
  gs.linear.heed_verdict (who, m, verdict, text);
endfunction
