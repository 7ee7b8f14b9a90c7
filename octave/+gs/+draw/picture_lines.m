## lines = gs.draw.picture_lines (skeleton, p, shades, path, s, title, o)
## The lines of gnuplot that draw one picture.

function lines = picture_lines (skeleton, p, shades, path, s, title, o)
  d.data = d.plots = d.keys = {};
  d.dims = numel (s.axes);
  f.first = [0; cumsum(skeleton.points)(1:end-1)];
  f.bodies = 2:numel (skeleton.body);
  f.corners = arrayfun (@(b) corners_of (p(:,f.first(b) + (1:skeleton.joints(b)),1), ...
                                         is_beam (skeleton, b)), ...
                        1:numel (skeleton.body), "UniformOutput", false);
  d = below (d, skeleton, p(:,:,end), f, s);
  track = "lines lw 1.5 lc rgb '#999999'";
  if (d.dims == 2)
    d = add (d, path, s, track);
  endif
  for k = 1:numel (shades)
    d = pose (d, skeleton, p(:,:,k), f, s, shades(k), o);
  endfor
  if (d.dims == 3)
    d = add (d, path, s, track);
  endif
  d = all_named (d, p(:,:,end), skeleton.marks.labels, s);
  d.keys = [keys_of(skeleton, p(:,:,end), f), skeleton.marks.key];
  if (! isempty (path))
    d.keys{end+1} = ["keyentry with " track " title " gs.text.gnuplot_quoted(o.traced)];
  endif
  command = {"plot ", "splot "}{d.dims - 1};
  lines = [{sprintf("set label 1 %s at screen 0.5,%.4f center", ...
                    gs.text.gnuplot_quoted (strtrim (title)), 1 - 20 / s.pixels(2))}, d.data, ...
           {[command strjoin([d.plots, d.keys], ", ")]}];
endfunction

## supports of the ground; in space what joins them, and the shadow of the bodies
function d = below (d, skeleton, p, f, s)
  supports = p(:,1:skeleton.joints(1));
  if (d.dims == 3)
    for b = f.bodies
      q = outline_of (skeleton, p, f, b);
      q(s.axes(3),:) = s.low(3);
      d = add (d, q, s, "lines lw 3 lc rgb '#c4c4c4'");
    endfor
    for one = skeleton.between(strcmp ({skeleton.between.kind}, "disc"))(:)'
      q = gs.draw.disc_rim (p(:,one.columns));
      q(s.axes(3),:) = s.low(3);
      d = add (d, q, s, "polygons fs solid noborder fc rgb '#dedede'");
    endfor
    if (columns (supports) >= 2)
      d = add (d, outline (supports, columns (supports), f.corners{1}), s, ...
               "lines lw 1.5 lc rgb '#888888'");
    endif
  endif
  for one = skeleton.between
    supports = [supports, p(:,one.columns(one.bodies == 1))];
  endfor
  for q = unique (round (supports' / (0.01 * s.mark)), "rows")'
    d = support (d, q * (0.01 * s.mark), s);
  endfor
endfunction

## all of one pose, in space the far ones first
function d = pose (d, skeleton, p, f, s, shade, o)
  order = [f.bodies, -(1:numel (skeleton.between))];   # below 0: what stands between them
  if (d.dims == 3)
    own = arrayfun (@(b) columns_of (skeleton, f, b), order, "UniformOutput", false);
    depth = cellfun (@(own) mean (s.eye' * p(:,own)), own);
    order = order(nthargout (2, @sort, depth));
  endif
  for label = skeleton.marks.labels
    d = tied (d, skeleton, p, f, label.column, label.body, s, shade);
  endfor
  for b = order
    own = columns_of (skeleton, f, b);
    if (b < 0)
      d = part (d, skeleton, p, f, skeleton.between(-b), s, shade);
      continue;
    elseif (! rolls (skeleton, b))
      d = link (d, p(:,own), skeleton.joints(b), f.corners{b}, s, skeleton.color{b}, shade, ...
                o.centres);
    endif
    if (d.dims == 3)   # a nearer link hides them
      d = marked (d, p, own, skeleton.marks.list, s, shade);
    endif
  endfor
  if (d.dims == 2)
    d = marked (d, p, 1:columns (p), skeleton.marks.list, s, shade);
  endif
endfunction

## entries of the legend for the bodies
function keys = keys_of (skeleton, p, f)
  keys = {};
  for b = f.bodies
    if (! isempty (skeleton.entry{b}))
      style = line_of (outline_of (skeleton, p, f, b));
      if (rolls (skeleton, b))
        style = "lines lw 3";
      endif
      keys{end+1} = sprintf ("keyentry with %s lc rgb '%s' title %s", style, ...
                             skeleton.color{b}, gs.text.gnuplot_quoted (skeleton.entry{b}));
    endif
  endfor
endfunction

function q = outline_of (skeleton, p, f, b)
  q = outline (p(:,f.first(b) + (1:skeleton.points(b))), skeleton.joints(b), f.corners{b});
endfunction

## the columns of a body, or of a part (B below 0)
function own = columns_of (skeleton, f, b)
  if (b < 0)
    own = skeleton.between(-b).columns;
  else
    own = f.first(b) + (1:skeleton.points(b));
  endif
endfunction

## whether a body is a disc alone, which is drawn as such
function yes = rolls (skeleton, b)
  discs = skeleton.between(strcmp ({skeleton.between.kind}, "disc"));
  yes = skeleton.points(b) == 1 && any ([discs.bodies] == b);
endfunction

## a cylinder, spring, damper or disc; thin lines lead from its ends to their links
function d = part (d, skeleton, p, f, one, s, shade)
  for k = find (one.bodies > 1 & ! strcmp (one.kind, "disc"))
    d = tied (d, skeleton, p, f, one.columns(k), one.bodies(k), s, shade);
  endfor
  for piece = gs.draw.part_symbol (one, p(:,one.columns), s)
    style = [piece.style " lc"];
    if (piece.filled)
      style = {"filledcurves closed fc", "polygons fs solid noborder fc"}{d.dims - 1};
    endif
    d = add (d, piece.points, s, sprintf ("%s rgb '%s'", style, lighter (piece.color, ...
        piece.tint * shade)));
  endfor
endfunction

## a thin line from the point in COLUMN to its link B
function d = tied (d, skeleton, p, f, column, b, s, shade)
  q = p(:,column);
  d = add (d, [q, nearest(q, outline_of (skeleton, p, f, b))], s, ...
           sprintf ("lines lw 2 lc rgb '%s'", lighter (skeleton.color{b}, shade)));
endfunction

## the point of a line through LINE that is closest to q
function best = nearest (q, line)
  best = line(:,1);
  for k = 1:columns (line) - 1
    step = line(:,k+1) - line(:,k);
    part = min (max (step' * (q - line(:,k)) / max (step' * step, realmin), 0), 1);
    foot = line(:,k) + part * step;
    if (norm (foot - q) < norm (best - q))
      best = foot;
    endif
  endfor
endfunction

## the marks of the points OWN of a pose
function d = marked (d, here, own, list, s, shade)
  for mark = list
    q = here(:,intersect (mark.columns, own));
    d = add (d, q, s, mark.under);
    d = add (d, q, s, sprintf ("%s lc rgb '%s'", mark.over, lighter ("#222222", shade)));
  endfor
endfunction

## the points of the scene in a pose, those at one place with their names together
function d = all_named (d, here, labels, s)
  while (! isempty (labels))
    q = here(:,labels(1).column);
    same = max (abs (here(:,[labels.column]) - q), [], 1) <= 0.2 * s.mark;
    d = named (d, q, strjoin ({labels(same).name}, ","), s);
    labels = labels(! same);
  endwhile
endfunction

## a point of the scene with its name beside it
function d = named (d, q, name, s)
  d = add (d, q, s, "points pt 7 ps 0.7 lc rgb '#111111'");
  block = sprintf ("$D%d", numel (d.data) + 1);
  d.data{end+1} = sprintf (["%s << EOD\n" repmat("%.9g ", 1, d.dims) "%s\nEOD"], block, ...
                           q(s.axes), name);
  d.plots{end+1} = sprintf ("%s with labels offset 1,0.7 left font ',10' notitle", block);
endfunction

## one link in one pose: plate, arm to the mass centre, line
function d = link (d, here, joints, corners, s, color, shade, centres)
  q = outline (here, joints, corners);
  if (columns (q) > 3 && ! corners.open)
    d = add (d, q, s, ...
             sprintf ("%s fc rgb '%s'", ...
                      {"filledcurves closed", "polygons fs solid noborder"}{d.dims - 1}, ...
                      lighter (color, 0.25 * shade)));
  endif
  if (centres && columns (here) > joints && joints > 1)
    d = add (d, [mean(here(:,1:joints), 2), here(:,end)], s, ...
             sprintf ("lines lw 1.2 lc rgb '%s'", lighter (color, shade)));
  endif
  d = add (d, q, s, sprintf ("%s lc rgb '%s'", line_of (q), lighter (color, shade)));
endfunction

function style = line_of (q)
  style = {"lines lw 5", "points pt 4 ps 2.4 lw 3.5"}{1 + (columns (q) == 1)};
endfunction

## the corners of a link: its joints (a closed polygon from three on; of a beam the line through its
## sections), or its only joint and the mass centre
function q = outline (q, joints, corners)
  if (joints >= 2)
    q = q(:,corners.order);
  endif
  if (corners.open)
    q = smooth (q);
  endif
  if (joints >= 3 && ! corners.open)
    q(:,end+1) = q(:,1);
  endif
  if (all (max (q, [], 2) - min (q, [], 2) <= 1e-12))
    q = q(:,1);
  endif
endfunction

## a smooth line through points
function q = smooth (q)
  t = [0, cumsum(sqrt (sumsq (diff (q, 1, 2), 1)))];
  apart = [true, diff(t) > 1e-9 * t(end)];
  if (sum (apart) > 2)
    q = spline (t(apart), q(:,apart), linspace (0, t(end), 33));
  endif
endfunction

## a beam: sections stand on it, which have a joint of their own each
function yes = is_beam (skeleton, b)
  yes = isfield (skeleton, "types") && skeleton.joints(b) > 1 ...
        && any (strcmp (skeleton.types{b}, "section"));
endfunction

## the order in which the line of a link goes through its joints, and whether it stays open
function corners = corners_of (q, beam)
  corners = struct ("order", around (q), "open", beam);
  if (beam)
    [U, S, ~] = svd (q - mean (q, 2));
    corners.open = columns (q) < 3 || S(2,2) < 0.15 * S(1,1);   # nodes of a plate are no line
    if (corners.open)
      [~, corners.order] = sort (U(:,1)' * q);
    endif
  endif
endfunction

## the order of points around their middle, so that a plate does not cross itself
function order = around (q)
  order = 1:columns (q);
  if (columns (q) > 3)
    [U, S, ~] = svd (q - mean (q, 2));
    if (S(2,2) > 1e-6 * S(1,1))
      flat = U(:,1:2)' * (q - mean (q, 2));
      [~, order] = sort (atan2 (flat(2,:), flat(1,:)));
    endif
  endif
endfunction

## points Q as a data block of gnuplot and what draws them; NaN separates pieces
function d = add (d, q, s, style)
  if (isempty (q))
    return;
  endif
  name = sprintf ("$D%d", numel (d.data) + 1);
  text = sprintf ([repmat("%.9g ", 1, d.dims) "\n"], q(s.axes,:));
  text = regexprep (text, "NaN[^\n]*", "");
  d.data{end+1} = sprintf ("%s << EOD\n%sEOD", name, text);
  d.plots{end+1} = sprintf ("%s with %s notitle", name, style);
endfunction

## the support below a joint of the ground: triangle or pyramid, and hatching
function d = support (d, at, s)
  h = s.mark;
  gap = NaN (3, 1);
  up = zeros (3, 1);
  up(s.axes(end)) = 1;
  side = zeros (3, 1);
  side(s.axes(1)) = 1;
  foot = at - h * up;
  grey = "lines lw 1.5 lc rgb '#444444'";
  if (d.dims == 2)
    body = [at, foot - 0.6*h*side, foot + 0.6*h*side, at];
  else
    deep = zeros (3, 1);
    deep(s.axes(2)) = 1;
    c = [foot - 0.5*h*(side + deep), foot + 0.5*h*(side - deep), foot + 0.5*h*(side + deep), ...
         foot - 0.5*h*(side - deep)];
    body = [c(:,[1:4 1]), gap, c(:,1), at, c(:,3), gap, c(:,2), at, c(:,4)];
  endif
  hatch = [foot - h*side, foot + h*side, gap];
  for x = linspace (-0.7, 1, 5)
    hatch = [hatch, foot + x*h*side, foot + (x - 0.3)*h*side - 0.35*h*up, gap];
  endfor
  d = add (d, [body, gap, hatch], s, grey);
endfunction

## a colour mixed with white: SHADE 1 is the colour itself
function color = lighter (color, shade)
  rgb = hex2dec ({color(2:3), color(4:5), color(6:7)})';
  color = sprintf ("#%02x%02x%02x", round (255 - shade * (255 - rgb)));
endfunction
