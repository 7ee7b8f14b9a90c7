## list = gs.report.drawn_solids (drawing, first, d)
## The solids of gs.report.drawn_scene: shapes of the links or what stands for them, marks of the
## joints, discs that roll.  FIRST: texts => numbers at the first time; D: bodies with their
## colours, extent.

function list = drawn_solids (drawing, first, d)
  list = [solids_of_bodies(drawing, first, d), solids_of_joints(drawing, first, d), ...
          solids_of_wheels(drawing, first, d)];
endfunction

function s = solid (kind, body, L, offset, color)
  s = struct ("kind", kind, "body", body, "m", [L(:)', offset(:)'], "color", color);
endfunction

## the shapes of the links; where there are none, a body of equal inertia; rods to its joints; of a
## beam its bent axis is drawn
function list = solids_of_bodies (drawing, first, d)
  list = {};
  for b = 1:numel (drawing.bodies)
    body = drawing.bodies(b);
    color = d.bodies{b+1}.color;
    c = first (body.centre);
    bent = any (cellfun (@(beam) beam.body == b, d.beams));
    shapes = gs.model.struct_list (body.shapes);
    for s = shapes
      list{end+1} = shape (s, first, b, c, color);
    endfor
    wheels = gs.model.struct_list (drawing.wheels);
    if (isempty (shapes) && ! bent && ! (! isempty (wheels) && any ([wheels.body] == b)))
      I = reshape (first (body.inertia), 3, 3);
      list = [list, equal_inertia(first ({body.mass}), I, b, c, color, d.extent), ...
              rods(drawing, first, b, c, color, d.extent)];
    endif
  endfor
endfunction

function s = shape (s, first, b, c, color)
  sizes = first (s.sizes);
  if (strcmp (s.kind, "box"))
    L = diag (sizes);
  elseif (strcmp (s.kind, "sphere"))
    L = sizes * eye (3);
  else
    L = frame_of (first (s.axis)) * diag ([sizes([1 1]), sizes(2)]);
  endif
  s = solid (s.kind, b, L, c, color);
endfunction

## a right-handed frame whose third axis is that of a cylinder
function R = frame_of (axis)
  z = axis(:) / norm (axis);
  [~, k] = min (abs (z));
  x = cross (eye (3)(:,k), z);
  x /= norm (x);
  R = [x, cross(z, x), z];
endfunction

## that box, by its edges alone where it would hide the others; a sphere where there is mass alone,
## nothing without mass
function list = equal_inertia (mass, I, b, c, color, extent)
  list = {};
  [R, size] = gs.report.inertia_box (mass, I);
  if (mass > 0 && max (size) < 0.02 * extent)
    list = {solid("sphere", b, 0.03 * extent * eye (3), c, color)};
  elseif (mass > 0)
    kind = {"box", "edges"}{1 + (median (size) > 0.3 * extent)};
    list = {solid(kind, b, R * diag (max (size, 0.018 * extent)), c, color)};
  endif
endfunction

## from the mass centre to the joints of a body, as far as they are apart
function list = rods (drawing, first, b, c, color, extent)
  list = {};
  for j = gs.model.struct_list (drawing.joints)
    if (strcmp (j.type, "free"))
      continue;
    endif
    ends = {first(j.at), first(j.child_at)}([j.body == b, j.child == b]);
    for p = ends
      z = p{1} - c;
      if (norm (z) > 0.01 * extent)
        L = frame_of (z) * diag ([0.008 * extent * [1 1], norm(z)]);
        list{end+1} = solid ("cylinder", b, L, c + z / 2, color);
      endif
    endfor
  endfor
endfunction

## marks of the joints, on the parent: a pin along the axis, a block, a ball
function list = solids_of_joints (drawing, first, d)
  list = {};
  grey = [.32 .33 .35];
  r = 0.014 * d.extent;
  for j = gs.model.struct_list (drawing.joints)
    at = first (j.at);
    R = frame_of (first (j.axis));
    switch (j.type)
      case {"revolute", "cylindrical", "helical"}
        list{end+1} = solid ("cylinder", j.body, R * diag (r * [1.2 1.2 3.2]), at, grey);
      case {"prismatic", "planar", "fixed"}
        list{end+1} = solid ("box", j.body, R * diag (r * [2.2 2.2 2.8]), at, grey);
      case {"spherical", "universal"}
        list{end+1} = solid ("sphere", j.body, 1.3 * r * eye (3), at, grey);
    endswitch
  endfor
endfunction

## discs that roll, with two spokes that show how they turn
function list = solids_of_wheels (drawing, first, d)
  list = {};
  for w = gs.model.struct_list (drawing.wheels)
    c = first (w.centre);
    R = frame_of (first (w.axis));
    radius = first ({w.radius});
    color = d.bodies{w.body+1}.color;
    thick = max (0.03 * radius, 0.005 * d.extent);
    list{end+1} = solid ("cylinder", w.body, R * diag ([radius, radius, thick]), c, color);
    for k = 1:2
      size = [2 0.1; 0.1 2](k,:) * 0.95 * radius;
      list{end+1} = solid ("box", w.body, R * diag ([size, 1.3 * thick]), c, [.95 .95 .95]);
    endfor
  endfor
endfunction
