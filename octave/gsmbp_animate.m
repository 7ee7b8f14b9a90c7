## -*- texinfo -*-
## @deftypefn  {} {} gsmbp_animate (@var{m}, @var{result}, @var{file})
## @deftypefnx {} {} gsmbp_animate (@var{m}, @var{result}, @var{file}, @var{options}, @dots{})
## Draw the skeletal diagram of a scene along a motion, without a screen.
##
## @var{m} is a model of @code{gsmbp_build} with the handle @code{m.ske};
## @var{result} comes from @code{gsmbp_simulate} or @code{gsmbp_inverse}: its
## fields @code{t} [s] (@var{nt} increasing times) and @code{q}
## (@var{nt} x @var{nq}) or @code{x} (@var{nt} x @var{nx}) are used.
## @var{file} ends in
## @table @file
## @item .gif
## a moving picture, again and again
## @item .png
## several poses in one picture, the earlier the lighter: start, middle, end
## @end table
##
## A link is a thick line through its joints (from three on a plate with these
## corners) and, where it has but one, to its mass centre; a link that is a
## single point is a square.  Joints are circles, where the model knows their
## types a mark for each type; mass centres are small crosses (none where it
## stands in a joint; a thin line leads there from its link).  Joints on the
## ground stand on a hatched support; in space a thin grey line joins them. All axes have the same
## scale and stand still. If all points stay in one coordinate plane the picture is flat, otherwise
## isometric, what is near over what is far, with a grey shadow below.  Of more
## than seven links, those whose names differ in their last digits alone have
## one colour and one entry in the legend.
##
## The points of the poses drawn go into the .csv beside the picture, a row for
## each pose: @var{t}, then x, y, z of each column of @code{m.ske} [m].
##
## Options:
## @table @code
## @item "times"
## the instants to draw [s].  The row of @var{result} that is nearest is drawn;
## nothing is interpolated.
## @item "speed", "fps"
## .gif: how fast, 1 (default) is real time; pictures per second, default 20,
## at most 50
## @item "trace"
## the path of one point: a column of @code{m.ske}, or the name of a link for
## its last one (mass centre, if it has one)
## @item "title"
## text above
## @item "view"
## spatial scenes: [tilt, turn] of gnuplot's @code{set view} [degrees]
## @item "centres"
## false: no marks for mass centres
## @item "up"
## spatial scenes: the axis that points upwards, "x", "y" or "z" (default)
## @item "width"
## of the picture, in pixels: default 720
## @end table
##
## @example
## gsmbp_animate (m, gsmbp_simulate (m, x0, 0:0.02:2), "out/motion.gif", "trace", "rod")
## @end example
##
## Errors: a result without t and q or x of one size; a model without the
## handle ske; a file that is neither .gif nor .png or cannot be written; an
## option that is unknown or out of its range; gnuplot missing.
## Source: own; the drawing is gnuplot's.
## @seealso{gsmbp_build, gsmbp_simulate, gsmbp_inverse, gsmbp_plot}
## @end deftypefn

function gsmbp_animate (m, result, file, varargin)
  if (nargin < 3 || ! isstruct (m) || ! ischar (file))
    print_usage ();
  endif
  who = "gsmbp_animate";
  table = {"times", [], "numbers"
           "speed", 1, "positive"
           "fps", 20, "positive"
           "trace", [], "any"
           "title", "", "text"
           "view", [54.7, 130], "numbers"
           "up", "z", {"x", "y", "z"}
           "centres", true, "flag"
           "width", 720, "positive"};
  o = gsmbp__options (who, table, varargin);
  moving = numel (file) > 4 && strcmpi (file(end-3:end), ".gif");
  if (! moving && ! (numel (file) > 4 && strcmpi (file(end-3:end), ".png")))
    error ("%s: argument file must end in .gif or .png, found: %s", who, file);
  endif
  [t, q] = motion (who, m, result);
  o = checked (who, o, m.skeleton, t);
  rows_drawn = poses (t, o, moving);
  rows_traced = unique ([rows_drawn, round(linspace (1, numel (t), min (numel (t), 1000)))]);
  points = @(list) cell2mat (reshape (arrayfun (@(k) m.ske (t(k), q(k,:)'), list, ...
                                        "UniformOutput", false), 1, 1, []));
  p = points (rows_drawn);
  path = zeros (3, 0);
  if (! isempty (o.trace))
    path = reshape (points (rows_traced)(:,o.trace,:), 3, []);
  endif

  table = sprintf ("%s-%d.csv", file(1:end-4), getpid ());
  guard = onCleanup (@() gsmbp__discard (table));
  gsmbp_csv (table, heads (m.skeleton), [t(rows_drawn), reshape(p, [], numel (rows_drawn))']);
  [m.skeleton.color, m.skeleton.entry] = entries (m.skeleton.body);
  m.skeleton.marks = marks (m.skeleton, o.centres);
  named = m.skeleton.entry(! cellfun (@isempty, m.skeleton.entry));
  s = stage (p, path, o, numel (named) + numel (m.skeleton.marks.key) + ! isempty (path), ...
             max (cellfun (@numel, [named, {o.traced, "mass centre"}])));
  lines = axes_of (s, o);
  n = numel (rows_drawn);
  if (moving)
    digits = max (2, ceil (-log10 (min ([diff(t(rows_drawn))(:); 1]) + 1e-12)));
    for k = 1:n
      lines = [lines, ...
               picture(m.skeleton, p(:,:,k), 1, path, s, ...
                       sprintf("%s   t = %.*f s", o.title, digits, t(rows_drawn(k))), o)];
    endfor
    terminal = sprintf (["gif animate optimize delay %d loop 0 noenhanced size %d,%d font " ...
                         "'FreeSans,11'"], o.delay, s.pixels);
  else
    instants = strjoin (arrayfun (@(x) sprintf ("%.4g", x), t(rows_drawn)', "UniformOutput", ...
                                  false), ", ");
    shades = linspace (1 - 0.7 * (n > 1), 1, n);
    shades(end) = 1;
    order = {"", ", light to dark"}{1 + (n > 1)};
    lines = [lines, ...
             picture(m.skeleton, p, shades, path, s, ...
                     sprintf("%s   t = %s s%s", o.title, instants, order), o)];
    terminal = sprintf ("pngcairo noenhanced size %d,%d font 'FreeSans,12'", s.pixels);
  endif
  gsmbp__gnuplot (who, file, terminal, lines, table);
endfunction

## ------------------------------------------------------- what is to be drawn

## times and coordinates of the result
function [t, q] = motion (who, m, result)
  if (! isfield (m, "ske") || ! isfield (m, "skeleton") || isempty (m.skeleton.points))
    error (["%s: argument m has no handle ske: emit the scene with the request " ...
            "skeleton (gsmbp_fortran)"], who);
  endif
  if (! (isstruct (result) && isscalar (result) && isfield (result, "t") ...
           && any (isfield (result, {"q", "x"}))))
    error (["%s: argument result must be a struct with the fields t and q or x, found: " "%s"], ...
           who, class (result));
  endif
  t = gsmbp__times (who, result.t)';
  field = {"x", "q"}{1 + isfield(result, "q")};
  q = result.(field);
  if (rows (q) != numel (t) || columns (q) < m.sizes.nq ...
        || (field == "q" && columns (q) != m.sizes.nq))
    error (["%s: argument result: expected %s with %d rows and the %d coordinates of " ...
            "%s, found %d x %d"], who, field, numel (t), m.sizes.nq, m.name, size (q));
  endif
  q = q(:,1:m.sizes.nq);
endfunction

function o = checked (who, o, skeleton, t)
  if (o.fps > 50)
    error (["%s: option fps must be at most 50 (a GIF counts hundredths of a second), " ...
            "found: %g"], who, o.fps);
  endif
  o.delay = round (100 / o.fps);
  if (! (isnumeric (o.view) && numel (o.view) == 2 && all (isfinite (o.view)) && o.view(1) >= 0 ...
           && o.view(1) <= 180))
    error ("%s: option view must be two angles [tilt, turn] in degrees, tilt from 0 to 180", who);
  endif
  o.view(2) = mod (o.view(2), 360);
  slack = 1e-9 * (1 + abs (t(end)) + abs (t(1)));
  if (! (isnumeric (o.times) && all (o.times(:) >= t(1) - slack) ...
           && all (o.times(:) <= t(end) + slack)))
    error ("%s: option times must lie within the result, from %.9g to %.9g s", who, t(1), t(end));
  endif
  [o.trace, o.traced] = traced (who, o.trace, skeleton);
endfunction

## the column of m.ske that option trace means, and its name
function [column, name] = traced (who, wanted, skeleton)
  column = [];
  name = "";
  last = cumsum (skeleton.points);
  if (ischar (wanted) && ! isempty (wanted))
    k = find (strcmp (skeleton.body, wanted));
    if (isempty (k) || skeleton.points(k) == 0)
      error ("%s: option trace: no link \"%s\"; known: %s", who, wanted, ...
             strjoin (skeleton.body(2:end)', ", "));
    endif
    column = last(k);
  elseif (! isempty (wanted))
    if (! (isnumeric (wanted) && isscalar (wanted) && any (wanted == 1:last(end))))
      error ("%s: option trace must be the name of a link or a column of m.ske, 1 to %d", who, ...
             last(end));
    endif
    column = wanted;
    k = find (column <= last, 1);
  endif
  if (! isempty (column))
    inside = column - last(k) + skeleton.points(k);
    name = ["path of " skeleton.body{k}];
    if (skeleton.points(k) > 1)
      name = sprintf ("%s, %s", name, ...
                      {"mass centre", sprintf("joint %d", inside)}{1 ...
                          + (inside <= skeleton.joints(k))});
    endif
  endif
endfunction

## the rows of the result that are drawn
function list = poses (t, o, moving)
  at = o.times(:)';
  if (isempty (at) && moving)
    at = t(1):o.speed * o.delay / 100:t(end);
  elseif (isempty (at))
    at = t(1) + (t(end) - t(1)) * [0 0.5 1];
  endif
  list = arrayfun (@(x) find (abs (t - x) == min (abs (t - x)), 1), at);
  if (! moving)
    list = unique (list);
  endif
endfunction

function names = heads (skeleton)
  names = {"t"};
  for b = 1:numel (skeleton.body)
    for k = 1:skeleton.points(b)
      names = [names, ...
               cellfun(@(c) sprintf ("%s.%d.%s", skeleton.body{b}, k, c), {"x", "y", "z"}, ...
                       "UniformOutput", false)];
    endfor
  endfor
endfunction

## ------------------------------------------------------------ where it stands

## s.axes: the two or three coordinates drawn, the last one upwards; s.eye: towards the eye, in
## ground axes; s.low, s.high: the room; s.mark: size of a support; s.pixels: of the picture;
## ENTRIES: of the legend, the longest one of LETTERS
function s = stage (p, path, o, entries, letters)
  all_points = [reshape(p, 3, []), path];
  low = min (all_points, [], 2);
  high = max (all_points, [], 2);
  extent = max (max (high - low), 1e-3);
  flat = find (high - low <= 1e-9 * extent);
  s.axes = circshift (1:3, find ("zyx" == o.up) - 1);   # the last one upwards
  if (! isempty (flat))
    s.axes = setdiff (1:3, flat(end));
  endif
  s.mark = 0.05 * extent;
  s.low = low(s.axes) - 0.07 * extent;
  s.high = high(s.axes) + 0.07 * extent;
  s.low(end) -= s.mark;
  room = s.high - s.low;
  lines = ceil (entries / min (3, 1 + floor (o.width / (7.5 * letters + 60) / 2)));
  below = 75 + 22 * lines;
  if (numel (s.axes) == 2)
    height = (o.width - 110) * room(2) / room(1) + 40 + below;
    s.pixels = round ([o.width, min(max (height, 300), 1.2 * o.width)]);
    s.key = [(10 + 22 * lines) / s.pixels(2), lines];
    s.below = below / s.pixels(2);
    return;
  endif
  s.eye = zeros (3, 1);
  s.eye(s.axes) = [sind(o.view(1)) * sind(o.view(2)), -sind(o.view(1)) * cosd(o.view(2)), ...
                   cosd(o.view(1))];
  ## set view equal xyz: the longer of x and y spans the lesser side of what the margins leave, its
  ## middle in theirs
  wide = room(1) * abs (cosd (o.view(2))) + room(2) * abs (sind (o.view(2)));
  tall = (room(1) * abs (sind (o.view(2))) + room(2) * abs (cosd (o.view(2)))) ...
      * abs (cosd (o.view(1))) + room(3) * sind (o.view(1));
  scale = min ([(o.width - 170) / wide, 0.75 * o.width / tall, o.width / max(room(1:2))]);
  s.pixels = round ([o.width, scale * tall + below + 60]);
  half = scale * max (room(1:2)) / 2;
  middle = below + scale * tall / 2;
  s.key = [(10 + 22 * lines) / s.pixels(2), lines];
  s.margins = [o.width/2 - half, o.width/2 + half, middle - half, middle + half] ./ s.pixels([1 ...
          1 2 2]);
endfunction

function lines = axes_of (s, o)
  letters = "xyz"(s.axes);
  lines = ...
      {"set tmargin 2.5", "set grid lt 1 lc rgb '#cccccc'", ...
       "set key Left reverse samplen 2 spacing 1.2", "set tics nomirror", "set tics scale 0.6", ...
           sprintf("set key at screen 0.5,%.5f top center vertical maxrows %d width 2", s.key)};
  for k = 1:numel (letters)
    c = "xyz"(k);
    lines{end+1} = sprintf ("set %slabel '%s [m]'; set %srange [%.9g:%.9g]", c, letters(k), c, ...
                            s.low(k), s.high(k));
    lines{end+1} = sprintf ("set %stics %.9g", c, tick (max (s.high - s.low) / 7));
  endfor
  if (numel (letters) == 2)
    lines = [lines, {"set size ratio -1", sprintf("set bmargin at screen %.5f", s.below)}];
  else
    sides = {"l", "r", "b", "t"};
    for k = 1:4
      lines{end+1} = sprintf ("set %smargin at screen %.5f", sides{k}, s.margins(k));
    endfor
    lines = [lines, {sprintf("set view %.4g,%.4g; set view equal xyz", o.view), ...
                     sprintf("set xyplane at %.9g", s.low(3)), "set border 127 lc rgb '#888888'"}];
  endif
endfunction

## 1, 2 or 5 times a power of ten, not below x
function step = tick (x)
  power = 10 ^ floor (log10 (x));
  step = [1 2 5 10](find ([1 2 5 10] * power >= x * (1 - 1e-9), 1)) * power;
endfunction

## -------------------------------------------------------------- the drawing

## gnuplot's lines for one picture: poses P(:,:,k) in SHADES(k), the last one full
function lines = picture (skeleton, p, shades, path, s, title, o)
  d.data = d.plots = d.keys = {};
  d.dims = numel (s.axes);
  first = [0; cumsum(skeleton.points)(1:end-1)];
  bodies = 2:numel (skeleton.body);
  supports = p(:,1:skeleton.joints(1),end);
  corners = arrayfun (@(b) around (p(:,first(b) + (1:skeleton.joints(b)),1)), ...
                      1:numel (skeleton.body), "UniformOutput", false);
  if (d.dims == 3)
    for b = bodies
      q = outline (p(:,first(b) + (1:skeleton.points(b)),end), skeleton.joints(b), corners{b});
      q(s.axes(3),:) = s.low(3);
      d = add (d, q, s, "lines lw 3 lc rgb '#c4c4c4'");
    endfor
    if (columns (supports) >= 2)
      d = add (d, outline (supports, columns (supports), corners{1}), s, ...
               "lines lw 1.5 lc rgb '#888888'");
    endif
  endif
  for k = 1:columns (supports)
    d = support (d, supports(:,k), s);
  endfor
  track = "lines lw 1.5 lc rgb '#999999'";
  if (d.dims == 2)
    d = add (d, path, s, track);
  endif
  for k = 1:numel (shades)
    here = p(:,:,k);
    order = bodies;
    if (d.dims == 3)   # the far ones first
      depth = arrayfun (@(b) mean (s.eye' * here(:,first(b) + (1:skeleton.points(b)))), bodies);
      order = bodies(nthargout (2, @sort, depth));
    endif
    for b = order
      own = first(b) + (1:skeleton.points(b));
      d = link (d, here(:,own), skeleton.joints(b), corners{b}, s, skeleton.color{b}, shades(k), ...
                o.centres);
      if (d.dims == 3)   # a nearer link hides them
        d = marked (d, here, own, skeleton.marks.list, s, shades(k));
      endif
    endfor
    if (d.dims == 2)
      d = marked (d, here, 1:columns (here), skeleton.marks.list, s, shades(k));
    endif
  endfor
  if (d.dims == 3)
    d = add (d, path, s, track);
  endif
  for b = bodies
    if (! isempty (skeleton.entry{b}))
      q = outline (p(:,first(b) + (1:skeleton.points(b)),end), skeleton.joints(b), corners{b});
      d.keys{end+1} = sprintf ("keyentry with %s lc rgb '%s' title %s", line_of (q), ...
                               skeleton.color{b}, gsmbp__quoted (skeleton.entry{b}));
    endif
  endfor
  d.keys = [d.keys, skeleton.marks.key];
  if (! isempty (path))
    d.keys{end+1} = ["keyentry with " track " title " gsmbp__quoted(o.traced)];
  endif
  command = {"plot ", "splot "}{d.dims - 1};
  lines = [{sprintf("set label 1 %s at screen 0.5,%.4f center", gsmbp__quoted (strtrim (title)), ...
                    1 - 20 / s.pixels(2))}, d.data, ...
           {[command strjoin([d.plots, d.keys], ", ")]}];
endfunction

## the marks of the points OWN of a pose
function d = marked (d, here, own, list, s, shade)
  for mark = list
    q = here(:,intersect (mark.columns, own));
    d = add (d, q, s, mark.under);
    d = add (d, q, s, sprintf ("%s lc rgb '%s'", mark.over, lighter ("#222222", shade)));
  endfor
endfunction

## one link in one pose: plate, arm to the mass centre, line
function d = link (d, here, joints, corners, s, color, shade, centres)
  q = outline (here, joints, corners);
  if (columns (q) > 3)
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

## colour of each body, and what it is called in the legend (nothing if one before it speaks for
## both)
function [color, entry] = entries (body)
  family = entry = body(:)';
  if (numel (body) > 8)
    family = regexprep (family, '\d+$', "");
  endif
  kinds = unique (family, "stable");
  group = cellfun (@(f) find (strcmp (f, kinds)), family);
  color = [{"#888888"}, gsmbp__colors(max (group) - 1)](group);
  for g = 2:max (group)
    k = find (group == g);
    if (numel (k) > 1)
      entry{k(1)} = sprintf ("%s ... %s", body{k([1 end])});
      entry(k(2:end)) = {""};
    endif
  endfor
  entry{1} = "";
endfunction

## how points are marked: a list of structs with the columns of m.ske, what is drawn under and over
## them; key: the entries of the legend
function m = marks (skeleton, centres)
  column = 0;
  of = {};
  for b = 1:numel (skeleton.body)
    for k = 1:skeleton.points(b)
      column++;
      of{column} = "mass centre";
      if (k <= skeleton.joints(b))
        of{column} = "joint";
        if (isfield (skeleton, "types"))
          of{column} = skeleton.types{b}{k};
        endif
      endif
    endfor
  endfor
  ## type, gnuplot's point below (white or dark) and above
  table = {"joint", 7, 6; "revolute", 7, 6; "prismatic", 5, 4; "cylindrical", 11, 10; "helical", ...
           13, 12; "universal", 15, 14; "spherical", 7, 7; "planar", 9, 8; "fixed", 5, 5};
  m.list = struct ("columns", {}, "under", {}, "over", {});
  m.key = {};
  for row = table'
    columns = find (strcmp (of, row{1}));
    if (! isempty (columns))
      size = 1.3 - 0.4 * strcmp (row{1}, "fixed");
      m.list(end+1) = struct ("columns", columns, "under", ...
                              sprintf ("points pt %d ps %g lc rgb 'white'", row{2}, 1.3), ...
                              "over", sprintf ("points pt %d ps %g lw 1.6", row{3}, size));
      m.key{end+1} = sprintf ("keyentry with %s lc rgb '#222222' title '%s'", m.list(end).over, ...
                              row{1});
    endif
  endfor
  columns = find (strcmp (of, "mass centre"));
  if (centres && ! isempty (columns))
    m.list(end+1) = struct ("columns", columns, "under", "dots lc rgb 'white'", "over", ...
                            "points pt 2 ps 1.1 lw 1.6");
    m.key{end+1} = "keyentry with points pt 2 ps 1.1 lw 1.6 lc rgb '#222222' title 'mass centre'";
  endif
endfunction

## the corners of a link: its joints (a closed polygon from three on), or its only joint and the
## mass centre
function q = outline (q, joints, corners)
  if (joints >= 2)
    q = q(:,corners);
  endif
  if (joints >= 3)
    q(:,end+1) = q(:,1);
  endif
  if (all (max (q, [], 2) - min (q, [], 2) <= 1e-12))
    q = q(:,1);
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

%!function [m, r] = pendulum (spatial)
%!  m = struct ("name", "pendulum", "sizes", struct ("nq", 2));
%!  m.skeleton = struct ("body", {{"ground"; "upper"; "lower"}}, "points", [1; 3; 2], "joints", ...
%!                       [1; 2; 1]);
%!  e = @(a) [sin(a); spatial * a; -cos(a)];
%!  m.ske = @(t, q) [zeros(3, 2), e(q(1)), e(q(1))/2, e(q(1)), e(q(1)) + e(q(2))];
%!  t = (0:0.05:1)';
%!  r = struct ("t", t, "q", [sin(2*t), cos(3*t)]);
%!endfunction
%!function inside (job)
%!  if (isempty (file_in_path (getenv ("PATH"), "gnuplot")))
%!    return;
%!  endif
%!  folder = tempname ();
%!  mkdir (folder);
%!  unwind_protect
%!    job (folder);
%!  unwind_protect_cleanup
%!    confirm_recursive_rmdir (false, "local");
%!    rmdir (folder, "s");
%!  end_unwind_protect
%!endfunction
%!function n = frames (file)
%!  f = fopen (file);
%!  bytes = fread (f, Inf, "uint8=>uint8")';
%!  fclose (f);
%!  assert (char (bytes(1:6)), "GIF89a");
%!  n = numel (strfind (char (bytes), char ([33 249 4])));
%!endfunction
%!function moves (folder)
%!  [m, r] = pendulum (0);
%!  file = fullfile (folder, "a.gif");
%!  gsmbp_animate (m, r, file, "fps", 10, "trace", "lower");
%!  assert (frames (file), 11);
%!  table = dlmread (fullfile (folder, "a.csv"), ",", 1, 0);
%!  assert (size (table), [11, 19]);
%!  assert (reshape (table(3,2:end), 3, []), m.ske (0.2, r.q(5,:)'), 1e-15);
%!  gsmbp_animate (m, r, file, "fps", 10, "speed", 0.5);
%!  assert (frames (file), 21);
%!  assert (sort (cellstr (ls (folder)))', {"a.csv", "a.gif"});
%!endfunction
%!function stands (folder)
%!  [m, r] = pendulum (0.3);
%!  file = fullfile (folder, "o'ne.png");
%!  gsmbp_animate (m, struct ("t", r.t, "x", [r.q, r.q]), file, "times", [0 0.31 1], "title", ...
%!                 "it's", "trace", 3);
%!  assert (dlmread (fullfile (folder, "o'ne.csv"), ",", 1, 0)(:,1), [0; 0.3; 1], 1e-15);
%!  assert (stat (file).size > 3000);
%!endfunction
%!function spatial (folder)
%!  ## a plate on seven legs, joints of all types
%!  m = struct ("name", "plate", "sizes", struct ("nq", 1));
%!  m.skeleton = struct ("body", ...
%!                       {["ground"; "plate"; ...
%!                         arrayfun(@(k) sprintf ("leg%d", k), (1:7)', "UniformOutput", ...
%!                                  false)]}, "points", [7; 8; 2*ones(7, 1)], "joints", ...
%!                       [7; 7; 2*ones(7, 1)]);
%!  words = {"revolute", "prismatic", "cylindrical", "helical", "universal", "planar", "fixed"};
%!  m.skeleton.types = [{words; repmat({"spherical"}, 1, 7)}; ...
%!                      cellfun(@(w) {w, "spherical"}, words', "UniformOutput", false)];
%!  base = [cos(2*(1:7)); sin(2*(1:7)); zeros(1, 7)];
%!  up = @(q) base .* [0.5; 0.5; 0] + [0; 0; 1 + q];
%!  m.ske = @(t, q) [base, up(q), [0; 0; 1.2], reshape([base; up(q)], 3, [])];
%!  r = struct ("t", [0; 1], "q", [0; 0.2]);
%!  file = fullfile (folder, "plate.png");
%!  gsmbp_animate (m, r, file, "up", "y", "centres", false, "view", [70, 20]);
%!  assert (stat (file).size > 3000);
%!  m.skeleton = rmfield (m.skeleton, "types");
%!  gsmbp_animate (m, r, fullfile (folder, "plate.gif"), "times", [0 1]);
%!  assert (frames (fullfile (folder, "plate.gif")), 2);
%!endfunction
%!test # a plate on many legs, types of joints, another axis upwards
%! inside (@spatial);
%!test # moving: pictures, their times, the table beside
%! inside (@moves);
%!test # standing, spatial, from states
%! inside (@stands);
%!error <Invalid call> gsmbp_animate (1)
%!error <argument file must end in .gif or .png, found: a.pdf>
%! [m, r] = pendulum (0); gsmbp_animate (m, r, "a.pdf")
%!error <argument m has no handle ske>
%! [m, r] = pendulum (0); gsmbp_animate (rmfield (m, "ske"), r, "a.png")
%!error <argument result must be a struct> gsmbp_animate (pendulum (0), 1, "a.png")
%!error <argument result: expected q with 21 rows and the 2 coordinates of pendulum, found 21 x 1>
%! [m, r] = pendulum (0); r.q = r.q(:,1); gsmbp_animate (m, r, "a.png")
%!error <option fps must be at most 50>
%! [m, r] = pendulum (0); gsmbp_animate (m, r, "a.gif", "fps", 60)
%!error <option up: expected one of "x", "y", "z", found "w">
%! [m, r] = pendulum (0); gsmbp_animate (m, r, "a.png", "up", "w")
%!error <option times must lie within the result, from 0 to 1 s>
%! [m, r] = pendulum (0); gsmbp_animate (m, r, "a.png", "times", 2)
%!error <no link "rod"; known: upper, lower>
%! [m, r] = pendulum (0); gsmbp_animate (m, r, "a.png", "trace", "rod")
%!error <a column of m.ske, 1 to 6> [m, r] = pendulum (0); gsmbp_animate (m, r, "a.png", "trace", 7)
