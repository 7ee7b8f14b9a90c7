## [F, M] = pose_reaction (m, Y, NAME): force and moment of the output NAME = reaction(...) among
## the outputs Y of the model m; components left out are zero.

function [F, M] = pose_reaction (m, y, name)
  parts = {"x", "y", "z", "mx", "my", "mz"};
  f = cellfun (@(part) sum (y(strcmp (m.outputs, [name "." part]))), parts)(:);
  [F, M] = deal (f(1:3), f(4:6));
end
