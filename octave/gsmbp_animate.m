## -*- texinfo -*-
## @deftypefn  {} {} gsmbp_animate (@var{m}, @var{result}, @var{file})
## @deftypefnx {} {} gsmbp_animate (@var{m}, @var{result}, @var{file}, @var{option}, @var{value}, @dots{})
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
## A link is a thick line through its joints and, where it has but one, to its
## mass centre; a link that is a single point is a square.  Joints are circles,
## mass centres small crosses (none where it stands in a joint; a thin line
## leads there from its link), joints on the ground stand on a hatched support.  All axes have the same scale.  If all
## points stay in one coordinate plane the picture is flat, otherwise isometric
## with a grey shadow below.
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
## @item "width"
## of the picture, in pixels: default 720
## @end table
##
## @example
## gsmbp_animate (m, gsmbp_simulate (m, x0, 0:0.02:2), "out/motion.gif", "trace", "rod")
## @end example
## @seealso{gsmbp_build, gsmbp_simulate, gsmbp_inverse, gsmbp_plot}
## @end deftypefn

function gsmbp_animate (m, result, file, varargin)
  if (nargin < 3 || ! isstruct (m) || ! ischar (file))
    print_usage ();
  endif
  who = "gsmbp_animate";
  defaults = struct ("times", [], "speed", 1, "fps", 20, "trace", [], "title", "", "view", [54.7, 130], "width", 720);
  o = gsmbp__options (who, defaults, varargin);
  moving = numel (file) > 4 && strcmpi (file(end-3:end), ".gif");
  if (! moving && ! (numel (file) > 4 && strcmpi (file(end-3:end), ".png")))
    error ("%s: argument file must end in .gif or .png, found: %s", who, file);
  endif
  [t, q] = motion (who, m, result);
  o = checked (who, o, m.skeleton, t);
  rows_drawn = poses (t, o, moving);
  rows_traced = unique ([rows_drawn, round(linspace (1, numel (t), min (numel (t), 1000)))]);
  points = @(list) cell2mat (reshape (arrayfun (@(k) m.ske (t(k), q(k,:)'), list, "UniformOutput", false), 1, 1, []));
  p = points (rows_drawn);
  path = zeros (3, 0);
  if (! isempty (o.trace))
    path = reshape (points (rows_traced)(:,o.trace,:), 3, []);
  endif

  gsmbp_csv ([file(1:end-4) ".csv"], heads (m.skeleton), [t(rows_drawn), reshape(p, [], numel (rows_drawn))']);
  s = stage (p, path, o, numel (m.skeleton.body) + 1 + ! isempty (path));
  lines = axes_of (s, o);
  n = numel (rows_drawn);
  if (moving)
    for k = 1:n
      lines = [lines, picture(m.skeleton, p(:,:,k), 1, path, s, sprintf("%s   t = %.2f s", o.title, t(rows_drawn(k))), o)];
    endfor
    terminal = sprintf ("gif animate optimize delay %d loop 0 noenhanced size %d,%d font 'FreeSans,11'", o.delay, s.pixels);
  else
    instants = strjoin (arrayfun (@(x) sprintf ("%.4g", x), t(rows_drawn)', "UniformOutput", false), ", ");
    shades = linspace (1 - 0.7 * (n > 1), 1, n);
    shades(end) = 1;
    order = {"", ", light to dark"}{1 + (n > 1)};
    lines = [lines, picture(m.skeleton, p, shades, path, s, sprintf("%s   t = %s s%s", o.title, instants, order), o)];
    terminal = sprintf ("pngcairo noenhanced size %d,%d font 'FreeSans,12'", s.pixels);
  endif
  gsmbp__gnuplot (who, file, terminal, lines);
endfunction

## ------------------------------------------------------- what is to be drawn

## times and coordinates of the result
function [t, q] = motion (who, m, result)
  if (! isfield (m, "ske") || ! isfield (m, "skeleton") || isempty (m.skeleton.points))
    error ("%s: argument m has no handle ske: emit the scene with the request skeleton (gsmbp_fortran)", who);
  endif
  if (! (isstruct (result) && isscalar (result) && isfield (result, "t") && any (isfield (result, {"q", "x"}))))
    error ("%s: argument result must be a struct with the fields t and q or x, found: %s", who, class (result));
  endif
  t = gsmbp__times (who, result.t)';
  field = {"x", "q"}{1 + isfield(result, "q")};
  q = result.(field);
  if (rows (q) != numel (t) || columns (q) < m.sizes.nq || (field == "q" && columns (q) != m.sizes.nq))
    error ("%s: argument result: expected %s with %d rows and the %d coordinates of %s, found %d x %d", who, field, numel (t), m.sizes.nq, m.name, size (q));
  endif
  q = q(:,1:m.sizes.nq);
endfunction

function o = checked (who, o, skeleton, t)
  for name = {"speed", "fps", "width"}
    value = o.(name{1});
    if (! (isnumeric (value) && isscalar (value) && isfinite (value) && value > 0))
      error ("%s: option %s must be a number > 0", who, name{1});
    endif
  endfor
  if (o.fps > 50)
    error ("%s: option fps must be at most 50 (a GIF counts hundredths of a second), found: %g", who, o.fps);
  endif
  o.delay = round (100 / o.fps);
  if (! (isnumeric (o.view) && numel (o.view) == 2 && all (isfinite (o.view)) && o.view(1) >= 0 && o.view(1) <= 180))
    error ("%s: option view must be two angles [tilt, turn] in degrees, tilt from 0 to 180", who);
  endif
  o.view(2) = mod (o.view(2), 360);
  if (! ischar (o.title))
    error ("%s: option title must be a string, found a %s", who, class (o.title));
  endif
  slack = 1e-9 * (1 + abs (t(end)) + abs (t(1)));
  if (! (isnumeric (o.times) && all (o.times(:) >= t(1) - slack) && all (o.times(:) <= t(end) + slack)))
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
      error ("%s: option trace: no link \"%s\"; known: %s", who, wanted, strjoin (skeleton.body(2:end)', ", "));
    endif
    column = last(k);
  elseif (! isempty (wanted))
    if (! (isnumeric (wanted) && isscalar (wanted) && any (wanted == 1:last(end))))
      error ("%s: option trace must be the name of a link or a column of m.ske, 1 to %d", who, last(end));
    endif
    column = wanted;
    k = find (column <= last, 1);
  endif
  if (! isempty (column))
    inside = column - last(k) + skeleton.points(k);
    name = sprintf ("path of %s, %s", skeleton.body{k}, {"mass centre", sprintf("joint %d", inside)}{1 + (inside <= skeleton.joints(k))});
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
      names = [names, cellfun(@(c) sprintf ("%s.%d.%s", skeleton.body{b}, k, c), {"x", "y", "z"}, "UniformOutput", false)];
    endfor
  endfor
endfunction

## ------------------------------------------------------------ where it stands

## s.axes: the two or three coordinates drawn; s.low, s.high: the room; s.mark: size of a support; s.pixels: of the picture
function s = stage (p, path, o, entries)
  all_points = [reshape(p, 3, []), path];
  low = min (all_points, [], 2);
  high = max (all_points, [], 2);
  extent = max (max (high - low), 1e-3);
  flat = find (high - low <= 1e-9 * extent);
  s.axes = 1:3;
  if (! isempty (flat))
    s.axes(flat(end)) = [];
  endif
  s.mark = 0.05 * extent;
  s.low = low(s.axes) - 0.07 * extent;
  s.high = high(s.axes) + 0.07 * extent;
  s.low(end) -= s.mark;
  room = s.high - s.low;
  if (numel (s.axes) == 2)
    height = (o.width - 110) * room(2) / room(1) + 80 + 20 * ceil (entries / 2);
    s.pixels = round ([o.width, min(max (height, 300), 1.2 * o.width)]);
    return;
  endif
  ## set view equal xyz: the longer of x and y spans the lesser side of what the margins leave, its middle in theirs
  wide = room(1) * abs (cosd (o.view(2))) + room(2) * abs (sind (o.view(2)));
  tall = (room(1) * abs (sind (o.view(2))) + room(2) * abs (cosd (o.view(2)))) * abs (cosd (o.view(1))) + room(3) * sind (o.view(1));
  scale = min ([(o.width - 170) / wide, 0.75 * o.width / tall, o.width / max(room(1:2))]);
  lines = ceil (entries / 2);
  below = 75 + 22 * lines;
  s.pixels = round ([o.width, scale * tall + below + 60]);
  half = scale * max (room(1:2)) / 2;
  middle = below + scale * tall / 2;
  s.key = [(10 + 22 * lines) / s.pixels(2), lines];
  s.margins = [o.width/2 - half, o.width/2 + half, middle - half, middle + half] ./ s.pixels([1 1 2 2]);
endfunction

function lines = axes_of (s, o)
  letters = "xyz"(s.axes);
  lines = {"set tmargin 2.5", "set grid lt 1 lc rgb '#cccccc'", "set key bmargin center horizontal Left reverse samplen 2 spacing 1.2", "set tics nomirror", ...
           "set tics scale 0.6"};
  for k = 1:numel (letters)
    c = "xyz"(k);
    lines{end+1} = sprintf ("set %slabel '%s [m]'; set %srange [%.9g:%.9g]", c, letters(k), c, s.low(k), s.high(k));
    lines{end+1} = sprintf ("set %stics %.9g", c, tick (max (s.high - s.low) / 7));
  endfor
  if (numel (letters) == 2)
    lines{end+1} = "set size ratio -1";
  else
    sides = {"l", "r", "b", "t"};
    for k = 1:4
      lines{end+1} = sprintf ("set %smargin at screen %.5f", sides{k}, s.margins(k));
    endfor
    lines = [lines, {sprintf("set key at screen 0.5,%.5f top center vertical maxrows %d width 2", s.key), sprintf("set view %.4g,%.4g; set view equal xyz", o.view), ...
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
  colors = gsmbp__colors (numel (skeleton.body) - 1);
  joints = centres = supports = zeros (3, 0);
  supports = p(:,1:skeleton.joints(1),end);
  if (d.dims == 3)
    for b = 2:numel (skeleton.body)
      q = outline (p(:,first(b) + (1:skeleton.points(b)),end), skeleton.joints(b));
      q(3,:) = s.low(3);
      d = add (d, q, s, "lines lw 3 lc rgb '#c4c4c4'");
    endfor
  endif
  for k = 1:columns (supports)
    d = support (d, supports(:,k), s);
  endfor
  if (! isempty (path))
    d = add (d, path, s, "lines lw 1.5 lc rgb '#999999'");
  endif
  for k = 1:numel (shades)
    here = p(:,:,k);
    for b = 2:numel (skeleton.body)
      q = here(:,first(b) + (1:skeleton.points(b)));
      q = outline (q, skeleton.joints(b));
      style = {"lines lw 5", "points pt 4 ps 2.4 lw 3.5"}{1 + (columns (q) == 1)};
      style = sprintf ("%s lc rgb '%s'", style, lighter (colors{b-1}, shades(k)));
      if (skeleton.points(b) > skeleton.joints(b) && skeleton.joints(b) > 1)
        arm = [mean(q, 2), here(:,first(b) + skeleton.points(b))];
        d = add (d, arm, s, sprintf ("lines lw 1.2 lc rgb '%s'", lighter (colors{b-1}, shades(k))));
      endif
      d = add (d, q, s, style);
      if (k == numel (shades))
        d.keys{end+1} = sprintf ("keyentry with %s title %s", style, gsmbp__quoted (skeleton.body{b}));
      endif
    endfor
    is_joint = true (1, columns (here));
    for b = 1:numel (skeleton.body)
      is_joint(first(b) + (skeleton.joints(b)+1:skeleton.points(b))) = false;
    endfor
    dark = lighter ("#222222", shades(k));
    round_mark = {"points pt 7 ps 1.3 lc rgb 'white'", sprintf("points pt 6 ps 1.3 lw 1.6 lc rgb '%s'", dark)};
    cross = sprintf ("points pt 2 ps 1.1 lw 1.6 lc rgb '%s'", dark);
    d = add (d, here(:,is_joint), s, round_mark{1});
    d = add (d, here(:,is_joint), s, round_mark{2});
    d = add (d, here(:,! is_joint), s, cross);
  endfor
  d.keys{end+1} = ["keyentry with " round_mark{2} " title 'joint'"];
  if (! all (is_joint))
    d.keys{end+1} = ["keyentry with " cross " title 'mass centre'"];
  endif
  if (! isempty (path))
    d.keys{end+1} = ["keyentry with lines lw 1.5 lc rgb '#999999' title " gsmbp__quoted(o.traced)];
  endif
  command = {"plot ", "splot "}{d.dims - 1};
  lines = [{sprintf("set label 1 %s at screen 0.5,%.4f center", gsmbp__quoted (strtrim (title)), 1 - 20 / s.pixels(2))}, d.data, {[command strjoin([d.plots, d.keys], ", ")]}];
endfunction

## the corners of a link: its joints (a closed polygon from three on), or its only joint and the mass centre
function q = outline (q, joints)
  if (joints >= 2)
    q = q(:,1:joints);
  endif
  if (joints >= 3)
    q(:,end+1) = q(:,1);
  endif
  if (all (max (q, [], 2) - min (q, [], 2) <= 1e-12))
    q = q(:,1);
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
    deep = [0; 1; 0];
    c = [foot - 0.5*h*(side + deep), foot + 0.5*h*(side - deep), foot + 0.5*h*(side + deep), foot - 0.5*h*(side - deep)];
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
%!  m.skeleton = struct ("body", {{"ground"; "upper"; "lower"}}, "points", [1; 3; 2], "joints", [1; 2; 1]);
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
%!  gsmbp_animate (m, struct ("t", r.t, "x", [r.q, r.q]), file, "times", [0 0.31 1], "title", "it's", "trace", 3);
%!  assert (dlmread (fullfile (folder, "o'ne.csv"), ",", 1, 0)(:,1), [0; 0.3; 1], 1e-15);
%!  assert (stat (file).size > 3000);
%!endfunction
%!test # moving: pictures, their times, the table beside
%! inside (@moves);
%!test # standing, spatial, from states
%! inside (@stands);
%!error <Invalid call> gsmbp_animate (1)
%!error <argument file must end in .gif or .png, found: a.pdf> [m, r] = pendulum (0); gsmbp_animate (m, r, "a.pdf")
%!error <argument m has no handle ske> [m, r] = pendulum (0); gsmbp_animate (rmfield (m, "ske"), r, "a.png")
%!error <argument result must be a struct> gsmbp_animate (pendulum (0), 1, "a.png")
%!error <argument result: expected q with 21 rows and the 2 coordinates of pendulum, found 21 x 1> [m, r] = pendulum (0); r.q = r.q(:,1); gsmbp_animate (m, r, "a.png")
%!error <option fps must be at most 50> [m, r] = pendulum (0); gsmbp_animate (m, r, "a.gif", "fps", 60)
%!error <option times must lie within the result, from 0 to 1 s> [m, r] = pendulum (0); gsmbp_animate (m, r, "a.png", "times", 2)
%!error <no link "rod"; known: upper, lower> [m, r] = pendulum (0); gsmbp_animate (m, r, "a.png", "trace", "rod")
%!error <a column of m.ske, 1 to 6> [m, r] = pendulum (0); gsmbp_animate (m, r, "a.png", "trace", 7)
