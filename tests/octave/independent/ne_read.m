## m = ne_read (FILE): a case of tests/data (spec.json) as plain numbers, for the independent
## Newton-Euler formulation ne_*.
##
## Everything is in world axes in the configuration q = 0, where every body frame coincides with the
## world's:
##   m.gravity 3x1; m.body(b): name, mass, com 3x1, inertia 3x3 about com; m.joint(j): tree joints,
##   as ne_joint makes them; m.loop(l): the same, either
##   a whole joint or only `directions` 3xk along which the points coincide. Tree joint b leads to
##   body b (drawn to it or from it), from a body before it; m.spec is the file as it stands. A
##   model may have more, see random_scene: m.user, m.given, m.spring.
## Nothing here or in the other ne_ files uses GSMBP.

function m = ne_read (file)
  spec = jsondecode (fileread (file), "makeValidName", false);
  m = struct ("gravity", ne_numbers (spec.gravity), "body", [], "joint", [], "loop", [], "spec", ...
              spec);
  for s = items (spec, "bodies")
    inertia = ne_numbers (s{1}.inertia_com);
    if (isvector (inertia))
      inertia = diag (inertia);
    end
    m.body = [m.body, ...
              struct("name", s{1}.name, "mass", ne_numbers (s{1}.mass), "com", ...
                     ne_numbers (s{1}.com), "inertia", inertia)];
  end
  number = @(name) find (strcmp (name, [{"ground"}, {m.body.name}])) - 1;
  damping = @(name) 0;
  if (isfield (spec, "damping"))
    damping = @(name) ne_numbers (spec.damping.(name));
  end
  for s = items (spec, "joints")
    m.joint = ...
        [m.joint, ne_joint(s{1}.name, s{1}.type, number (s{1}.parent), number (s{1}.child), ...
                           "point", ne_numbers (s{1}.point), ...
                                 "axis", ne_numbers (s{1}.axis), "damping", damping (s{1}.name))];
  end
  for s = items (spec, "loop_joints")
    directions = eye (3);
    if (isfield (s{1}, "directions"))
      directions = ne_numbers (s{1}.directions)';
    end
    m.loop = ...
        [m.loop, ne_joint(s{1}.name, "spherical", number (s{1}.bodyA), number (s{1}.bodyB), ...
                          "point_a", ne_numbers (s{1}.pointA), ...
                               "point_b", ne_numbers (s{1}.pointB), "directions", directions)];
  end
end

## a list of the file as a row of structs in cells (jsondecode gives a struct array or a cell
## column)
function list = items (spec, field)
  list = {};
  if (isfield (spec, field))
    list = spec.(field);
    if (isstruct (list))
      list = num2cell (list);
    end
    list = list(:)';
  end
end
