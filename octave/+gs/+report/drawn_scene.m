## d = gs.report.drawn_scene (drawing, number, place, turn, t)
## What the player draws (share/report/player.js): bodies with colours, solids, pairs of points,
## arrows, beams with their axes (an instant in a row), camera.  NUMBER, PLACE, TURN: of
## gs.report.drawn_poses at the times T.

function d = drawn_scene (drawing, number, place, turn, t)
  first = @(texts) number (texts)(1,:);
  d.t = t;
  [d.beams, d.axes_of_beams] = beams_of (drawing, number, place, turn);
  points = [points_of(drawing, first, place, turn); reshape(d.axes_of_beams', 3, [])'];
  [d.bodies, d.extent, low, high] = bodies_of (drawing, first, place, turn, points);
  d.target = (low + high) / 2;
  flat = find (max (points, [], 1) - min (points, [], 1) < 1e-6 * d.extent);
  if (numel (flat) > 2)
    flat = [];                          # a single point that stays where it is
  endif
  d = camera (d, first (drawing.gravity), low, high, flat);
  for b = 1:numel (d.beams)
    d.beams{b}.color = d.bodies{d.beams{b}.body+1}.color;
  endfor
  d.solids = gs.report.drawn_solids (drawing, first, d);
  d.pairs = pairs_of (drawing, first);
  d.points = named_points (drawing, first);
  [d.arrows, d.arrows_v] = arrows_of (drawing, number, turn, d.extent, numel (t));
endfunction

## names, colours, mass centres, and the room that everything goes through
function [bodies, extent, low, high] = bodies_of (drawing, first, place, turn, points)
  bodies = {struct("name", "ground", "color", [.6 .6 .6], "centre", [0 0 0], "moves", false)};
  family = families ({drawing.bodies.name});
  for b = 1:numel (drawing.bodies)
    c = first (drawing.bodies(b).centre);
    path = on_body (place{b}, turn{b}, c);
    moves = max (max (path) - min (path)) > 1e-9;
    bodies{end+1} = struct ("name", drawing.bodies(b).name, "color", color_of (family(b)), ...
                            "centre", c, "moves", moves);
  endfor
  known = norm (max (points) - min (points));
  for b = 1:numel (drawing.bodies)
    path = on_body (place{b}, turn{b}, bodies{b+1}.centre);
    radius = size_of (drawing, first, b, known);
    points = [points; path - radius; path + radius];
  endfor
  low = min (points, [], 1);
  high = max (points, [], 1);
  extent = max ([norm(high - low), 1e-3]);
endfunction

## links that bend: their bodies, the lines between their places (pairs of numbers), and the places
## in ground axes, an instant in a row
function [list, axes_] = beams_of (drawing, number, place, turn)
  list = {};
  axes_ = zeros (rows (place{1}), 0);
  for beam = gs.model.struct_list (drawing.beams)
    b = beam.body;
    along = number (beam.places);
    for k = 1:3:columns (along)
      axes_ = [axes_, place{b} + turn{b}(:,1:3:9) .* along(:,k) ...
                      + turn{b}(:,2:3:9) .* along(:,k+1) + turn{b}(:,3:3:9) .* along(:,k+2)];
    endfor
    n = columns (along) / 3;
    lines_ = [1:n-1; 2:n];
    if (strcmp (beam.kind, "nodes"))
      lines_ = neighbours (reshape (along(1,:), 3, []));
    endif
    list{end+1} = struct ("body", b, "places", n, "lines", lines_(:)');
  endfor
endfunction

## pairs of places between which there is a line: none is nearer to both than they are to each other
## (the relative neighbourhood graph, which joins all)
function pairs = neighbours (p)
  d = sqrt (squeeze (sumsq (p - permute (p, [1, 3, 2]), 1)));
  nearest = min (max (permute (d, [1, 3, 2]), permute (d, [3, 1, 2])), [], 3);
  [a, b] = find (triu (nearest >= d * (1 - 1e-9), 1));
  pairs = [a'; b'];
endfunction

## the ways of mass centres, joints and ends of pairs
function points = points_of (drawing, first, place, turn)
  points = zeros (0, 3);
  for b = 1:numel (drawing.bodies)
    points = [points; on_body(place{b}, turn{b}, first (drawing.bodies(b).centre))];
  endfor
  for j = [joints_at_points(drawing), gs.model.struct_list(drawing.pairs)]
    points = [points; at_joint(j.body, first (j.at), place, turn); ...
              at_joint(j.child, first (j.child_at), place, turn)];
  endfor
  for p = named_points (drawing, first)
    points = [points; at_joint(p{1}.body, p{1}.at, place, turn)];
  endfor
endfunction

## points and frames of the scene; axes by rows
function list = named_points (drawing, first)
  list = {};
  if (isfield (drawing, "points"))
    for p = gs.model.struct_list (drawing.points)
      list{end+1} = struct ("name", p.name, "kind", p.kind, "body", p.body, "at", first (p.at), ...
                            "axes", first (p.axes));
    endfor
  endif
endfunction

## half the size of what is drawn of a body: of its shapes and discs, else of the box of equal
## inertia, which is no larger than the ways that are known
function radius = size_of (drawing, first, b, known)
  body = drawing.bodies(b);
  radius = 0;
  for s = gs.model.struct_list (body.shapes)
    sizes = first (s.sizes);
    radius = max ([radius, sizes * {0.5, 1}{1 + ! strcmp(s.kind, "box")}]);
  endfor
  for w = gs.model.struct_list (drawing.wheels)
    radius = max (radius, (w.body == b) * first ({w.radius}));
  endfor
  if (radius == 0)
    [~, size] = gs.report.inertia_box (first ({body.mass}), reshape (first (body.inertia), 3, 3));
    radius = max (size) / 2;
    if (known > 0)
      radius = min (radius, known / 2);
    endif
  endif
endfunction

## numbers of colours; of more than seven links, leg1, leg2, ... have one
function family = families (names)
  family = 1:numel (names);
  if (numel (names) > 7)
    stems = regexprep (names, '\d+$', "");
    [~, family] = ismember (stems, unique (stems, "stable"));
  endif
endfunction

function list = joints_at_points (drawing)
  list = gs.model.struct_list (drawing.joints);
  if (! isempty (list))
    list = list(! strcmp ({list.type}, "free"));
    list = rmfield (list, {"type", "axis"});
    [list.kind] = deal ("joint");
  endif
endfunction

function p = at_joint (b, at, place, turn)
  if (b == 0)
    p = at;
  else
    p = on_body (place{b}, turn{b}, at);
  endif
endfunction

## the path of a point of a body in ground axes
function p = on_body (place, turn, at)
  p = place + [turn(:,1:3) * at', turn(:,4:6) * at', turn(:,7:9) * at'];
endfunction

function color = color_of (b)
  table = [.04 .37 .65; .80 .36 .14; .18 .52 .27; .49 .27 .63; .66 .53 .12; .10 .55 .57; ...
           .70 .22 .44];
  color = table(mod (b - 1, rows (table)) + 1,:);
endfunction

## up: two level directions and the one upwards, against gravity; a flat scene (FLAT: the axes along
## which nothing stands apart) is seen from ahead
function d = camera (d, gravity, low, high, flat)
  up = [0 0 1];
  if (norm (gravity) > 0)
    up = -gravity / norm (gravity);
  endif
  e = eye (3);
  ahead = [];
  if (! isempty (flat) && abs (e(flat(1),:) * up') < 0.5)
    ahead = e(flat(1),:) - (e(flat(1),:) * up') * up;
  elseif (! isempty (flat))
    up = e(mod (flat(1), 3) + 1,:);      # seen along gravity
    ahead = e(flat(1),:);
    up = e(find (! ismember (1:3, flat(1)), 1, "last"),:);
  endif
  d.view = [-0.9, 0.35];
  if (! isempty (ahead))
    d.view = [0.12, 0.1];
  else
    ahead = e(find (abs (e * up') < 0.8, 1),:);
    ahead -= (ahead * up') * up;
  endif
  ahead /= norm (ahead);
  d.up = [ahead; cross(up, ahead); up];
  d.grid = isempty (flat) || abs (up * gravity') > 0.5 * norm (gravity);
  d.floor = d.target + up * (min ([low; high] * up') - d.target * up' - 0.08 * d.extent);
endfunction

## ------------------------------------------------------------ pairs and arrows

function list = pairs_of (drawing, first)
  list = {};
  for p = gs.model.struct_list (drawing.pairs)
    list{end+1} = struct ("kind", p.kind, "body", p.body, "at", first (p.at), "child", p.child, ...
                          "child_at", first (p.child_at));
  endfor
endfunction

## forces in ground axes; the largest is a quarter of the scene long
function [list, v] = arrows_of (drawing, number, turn, extent, nt)
  list = {};
  v = zeros (nt, 0);
  for f = gs.model.struct_list (drawing.forces)
    if (strcmp (f.kind, "force"))
      one = number (f.vector);
      if (strcmp (f.frame, "link"))
        R = turn{f.body};
        one = [sum(R(:,1:3) .* one, 2), sum(R(:,4:6) .* one, 2), sum(R(:,7:9) .* one, 2)];
      endif
      list{end+1} = struct ("body", f.body, "at", number (f.at)(1,:), "name", f.name);
      v = [v, one];
    endif
  endfor
  most = max ([sqrt(max (sum (reshape (v', 3, []) .^ 2, 1))), 0]);
  v *= 0.25 * extent / max (most, realmin);
endfunction
