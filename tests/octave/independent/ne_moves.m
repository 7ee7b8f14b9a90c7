## moves = ne_moves (JOINT): the freedoms of a joint one after the other, from the parent on: a cell
## row of {kind, direction}, kind slide, turn, screw or ball (Euler parameters; the angular velocity
## in the child's joint axes for speeds), direction in joint axes.

function moves = ne_moves (joint)
  e = joint.axis;
  switch (joint.type)
    case "revolute"
      moves = {{"turn", e}};
    case "prismatic"
      moves = {{"slide", e}};
    case "helical"
      moves = {{"screw", e}};
    case "cylindrical"
      moves = {{"slide", e}, {"turn", e}};
    case "universal"
      moves = {{"turn", e}, {"turn", joint.second}};
    case "planar"
      first = e([3, 1, 2]);               # x: y, z;  y: z, x;  z: x, y
      moves = {{"slide", first}, {"slide", ne_cross(e, first)}, {"turn", e}};
    case "spherical"
      moves = turns (joint);
    case "free"
      moves = [{{"slide", [1; 0; 0]}, {"slide", [0; 1; 0]}, {"slide", [0; 0; 1]}}, turns(joint)];
    case "fixed"
      moves = {};
    otherwise
      error ("ne_moves: no such joint: %s", joint.type);
  end
end

function moves = turns (joint)
  if (isempty (joint.orientation))
    moves = {{"ball", []}};
  else
    moves = arrayfun (@(k) {"turn", joint.orientation(:, k)}, 1:3, "UniformOutput", false);
  end
end
