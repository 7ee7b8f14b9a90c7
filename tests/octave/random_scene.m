## m = random_scene (SEED, KIND, FILE): a scene made by chance, written to FILE in the scene language and returned for the independent ne_*.
##
## KIND "tree": two to five links, branches, revolute and prismatic joints about any axes. KIND "loop": a ring of seven links, the last
## joint whole and cut, closed at q = 0. Link and joint frames are turned by chance, so that every placement of the language is used: nothing of the scene's
## frames enters m, whose data stand in world axes.

function m = random_scene (seed, kind, file)
  rand ("twister", seed);
  [~, name] = fileparts (file);
  loop = strcmp (kind, "loop");
  n = randi ([2, 5]) * ! loop + 7 * loop;
  m = struct ("gravity", decimals (3, 10), "body", [], "joint", [], "loop", []);
  turns = randi ([-2, 2], n + 1, 4);
  turns(! any (turns, 2), 1) = 1;
  turns(1, :) = [1, 0, 0, 0];               # the ground's frame is the world's
  origins = [zeros(1, 3); reshape(decimals (3 * n, 1), n, 3)];
  elements = {sprintf("gravity = %s", list (m.gravity))};
  for b = 1:n
    if (loop)
      parent = b - 1;
    else
      parent = randi ([0, b - 1]);
    end
    type = {"revolute", "prismatic"}{1 + (rand < 0.25)};
    [body, joint] = chance (b, parent, type);
    m.body = [m.body, body];
    m.joint = [m.joint, joint];
    elements{end + 1} = link_text (body, turns(b + 1, :), origins(b + 1, :));
    elements{end + 1} = joint_text (joint, turns, origins, sprintf (", coordinate = q%d, friction = %.2f", b, joint.damping));
  end
  if (loop)
    type = {"revolute", "prismatic"}{1 + (rand < 0.5)};
    [~, joint] = chance (n + 1, n, type);
    joint.child = 0;
    elements{end + 1} = joint_text (joint, turns, origins, ", cut = true");
    m.loop = struct ("name", joint.name, "bodyA", joint.parent, "bodyB", 0, "pointA", joint.point, "pointB", joint.point, "directions", [], ...
                     "type", type, "axis", joint.axis);
  end
  fid = fopen (file, "w");
  fprintf (fid, "%s\nscene : apply(gsmbp_scene, [\"%s\",\n  %s])$\n", helpers (), name, strjoin (elements, ",\n  "));
  fprintf (fid, "requests : [%s]$\n", {"mass, inverse, forward, rhs, energy", "constraints, rhs"}{1 + loop});
  fclose (fid);
end

function [body, joint] = chance (b, parent, type)
  shape = reshape (decimals (9, 1), 3, 3);
  inertia = round (100 * (shape * shape' + eye (3) / 10)) / 100;   # two decimals, positive definite
  axis = zeros (3, 1);
  while (! any (axis))
    axis = randi ([-2, 2], 3, 1);
  end
  body = struct ("name", sprintf ("b%d", b), "mass", round (50 + 200 * rand) / 100, "com", decimals (3, 1), "inertia", inertia);
  joint = struct ("name", sprintf ("j%d", b), "type", type, "parent", parent, "child", b, "point", decimals (3, 1), "axis", axis / norm (axis), ...
                  "damping", round (10 * rand) / 100, "whole_axis", axis);
end

function x = decimals (n, size)
  x = round (100 * size * (2 * rand (n, 1) - 1)) / 100;
end

## Maxima: rotation of a quaternion of integers, points and vectors of the world in the axes of a link
function text = helpers ()
  text = ["turn(a, b, c, d) := matrix([a^2+b^2-c^2-d^2, 2*(b*c-a*d), 2*(b*d+a*c)], [2*(b*c+a*d), a^2-b^2+c^2-d^2, 2*(c*d-a*b)],\n" ...
          "  [2*(b*d-a*c), 2*(c*d+a*b), a^2-b^2-c^2+d^2]) / (a^2+b^2+c^2+d^2)$\n" ...
          "exact(x) := matrixmap(lambda([y], round(100*y)/100), x)$\n" ...
          "column(x) := transpose(matrix(x))$\n" ...
          "vector(x) := flatten(args(x))$\n" ...
          "seen(R, x) := vector(transpose(R) . exact(column(x)))$\n"];
end

function text = list (x)
  text = ["[" strjoin(arrayfun (@(y) sprintf ("%.2f", y), x(:)', "UniformOutput", false), ", ") "]"];
end

function text = turn (quaternion)
  text = sprintf ("turn(%d, %d, %d, %d)", quaternion);
end

function text = link_text (body, quaternion, origin)
  rows = strjoin (arrayfun (@(i) list (body.inertia(i, :)), 1:3, "UniformOutput", false), ", ");
  text = sprintf ("link(%s, mass = %.2f, centre = seen(%s, %s), inertia = transpose(%s) . exact(matrix(%s)) . %s)", body.name, body.mass, ...
                  turn (quaternion), list (body.com(:) - origin(:)), turn (quaternion), rows, turn (quaternion));
end

function text = joint_text (joint, turns, origins, options)
  hinge = randi ([-2, 2], 1, 4);
  if (! any (hinge))
    hinge(1) = 1;
  end
  name = @(b) {"ground", sprintf("b%d", b)}{1 + (b > 0)};
  place = @(b) list (joint.point(:) - origins(b + 1, :)');
  text = sprintf ("%s(%s, %s, %s, at = seen(%s, %s), rotation = transpose(%s) . %s, child_at = seen(%s, %s), child_rotation = transpose(%s) . %s, axis = seen(%s, %s)%s)", ...
                  joint.type, joint.name, name (joint.parent), name (joint.child), turn (turns(joint.parent + 1, :)), place (joint.parent), ...
                  turn (turns(joint.parent + 1, :)), turn (hinge), turn (turns(joint.child + 1, :)), place (joint.child), turn (turns(joint.child + 1, :)), turn (hinge), ...
                  turn (hinge), list (joint.whole_axis), options);
end
