## [nq, nu] = ne_sizes (JOINT): number of coordinates and of speeds of a joint.
## [nq, nu] = ne_sizes (M): of all tree joints of a model, a row of counts each.

function [nq, nu] = ne_sizes (m)
  if (isfield (m, "joint"))
    [nq, nu] = arrayfun (@ne_sizes, m.joint);
    return;
  end
  ball = strcmp (m.type, {"spherical", "free"}) & isempty (m.orientation);
  nu = ...
      struct ("revolute", 1, "prismatic", 1, "helical", 1, "cylindrical", 2, "universal", 2, ...
              "planar", 3, "spherical", 3, "free", 6, "fixed", 0, ...
               "rolling", 0).(m.type);
  nq = nu + any (ball);
end
