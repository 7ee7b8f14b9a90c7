## -*- texinfo -*-
## @c category Figures, tables, pages
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
## isometric, what is near over what is far, with a grey shadow below.
## Cylinders, springs and dampers between two points are drawn as such, and so are discs that roll,
## with a line to a point of the rim.  Of more
## than seven links, those whose names differ in their last digits alone have
## one colour and one entry in the legend.
##
## The points of the poses drawn go into the .csv beside the picture, a row for
## each pose: @var{t}, then x, y, z of each column of @code{m.ske} [m] and of each point of the
## scene.
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
## the path of one point: the name of a point or frame of the scene, a column of
## @code{m.ske}, or the name of a link for its last one (mass centre, if it has
## one)
## @item "points"
## false: no marks and names for the points and frames of the scene that move
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
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> r = gsmbp_inverse (m, gsmbp_plan ("quintic", [0 2*pi], [0 1]), (0:0.1:1)');
## >> gsmbp_animate (m, r, "crank.png")
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
  gs.given.refuse_words (who, "result", result);
  table = {"times", [], "numbers"
           "speed", 1, "positive"
           "fps", 20, "positive"
           "trace", [], "any"
           "title", "", "text"
           "view", [54.7, 130], "numbers"
           "up", "z", {"x", "y", "z"}
           "centres", true, "flag"
           "points", true, "flag"
           "width", 720, "positive"};
  o = gs.given.call_options (who, table, varargin);
  moving = numel (file) > 4 && strcmp (tolower (file(end-3:end)), ".gif");
  if (! moving && ! (numel (file) > 4 && strcmpi (file(end-3:end), ".png")))
    error ("%s: argument file must end in .gif or .png, found: %s", who, file);
  endif
  [t, q] = motion (who, m, result);
  if (! isfield (m.skeleton, "parts"))
    m.skeleton.parts = struct ("name", {}, "kind", {}, "bodies", {});
  endif
  named = named_points (m, o);
  o = gs.draw.animation_options (who, o, m.skeleton, t, named);
  rows_drawn = poses (t, o, moving);
  rows_traced = unique ([rows_drawn, round(linspace (1, numel (t), min (numel (t), 1000)))]);
  points = @(list) cell2mat (reshape (arrayfun (@(k) drawn (m, t(k), q(k,:)', named), list, ...
                                        "UniformOutput", false), 1, 1, []));
  p = points (rows_drawn);
  path = zeros (3, 0);
  if (! isempty (o.trace))
    path = reshape (points (rows_traced)(:,o.trace,:), 3, []);
  endif

  table = gs.files.new_beside (who, [file(1:end-4) ".csv"]);
  guard = onCleanup (@() gs.files.discard_file (table));
  gsmbp_csv (table, heads (m, named), [t(rows_drawn), reshape(p, [], numel (rows_drawn))']);
  [m.skeleton.color, m.skeleton.entry] = gs.draw.legend_entries (m.skeleton.body);
  m.skeleton.marks = gs.draw.joint_marks (m.skeleton, o.centres, named, links_of (m, named));
  m.skeleton.between = gs.draw.parts_between (m.skeleton, p);
  entries = m.skeleton.entry(! cellfun (@isempty, m.skeleton.entry));
  s = gs.draw.picture_stage (gs.draw.seen_points (m.skeleton, p), path, o, ...
                             numel (entries) + numel (m.skeleton.marks.key) + ! isempty (path), ...
                             max (cellfun (@numel, [entries, {o.traced, "mass centre"}])));
  lines = gs.draw.axis_lines (s, o);
  n = numel (rows_drawn);
  if (moving)
    digits = max (2, ceil (-log10 (min ([diff(t(rows_drawn))(:); 1]) + 1e-12)));
    for k = 1:n
      lines = [lines, ...
               gs.draw.picture_lines(m.skeleton, p(:,:,k), 1, path, s, ...
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
             gs.draw.picture_lines(m.skeleton, p, shades, path, s, ...
                     sprintf("%s   t = %s s%s", o.title, instants, order), o)];
    terminal = sprintf ("pngcairo noenhanced size %d,%d font 'FreeSans,12'", s.pixels);
  endif
  gs.files.run_gnuplot (who, file, terminal, lines, table);
endfunction

## ------------------------------------------------------- what is to be drawn

## times and coordinates of the result
function [t, q] = motion (who, m, result)
  if (isfield (m, "sizes"))
    gs.given.check_moving (who, m);
  endif
  if (! isfield (m, "ske") || ! isfield (m, "skeleton") || isempty (m.skeleton.points))
    error (["%s: argument m has no handle ske: emit the scene with the request " ...
            "skeleton (gsmbp_fortran)"], who);
  endif
  if (! (isstruct (result) && isscalar (result) && isfield (result, "t") ...
           && any (isfield (result, {"q", "x"}))))
    error (["%s: argument result must be a struct with the fields t and q or x, found: " "%s"], ...
           who, class (result));
  endif
  t = gs.given.given_times (who, result.t)';
  field = {"x", "q"}{1 + isfield(result, "q")};
  q = result.(field);
  if (rows (q) != numel (t) || columns (q) < m.sizes.nq ...
        || (field == "q" && columns (q) != m.sizes.nq))
    error (["%s: argument result: expected %s with %d rows and the %d coordinates of " ...
            "%s, found %d x %d"], who, field, numel (t), m.sizes.nq, m.name, size (q));
  endif
  q = q(:,1:m.sizes.nq);
endfunction

## points and frames of the scene, "" where one stands on ground and is not drawn
function names = named_points (m, o)
  names = {};
  if (o.points && isfield (m, "points") && ! isempty (m.points) ...
        && any (strcmp ("pnt", m.subroutines)))
    names = m.points(:)';
    on_link = ! strcmp ({m.json.points.link}, "ground");
    names(! on_link) = {""};
  endif
endfunction

function links = links_of (m, named)
  links = {};
  if (! isempty (named))
    links = {m.json.points.link};
  endif
endfunction

## the points of the skeleton, then those of the scene
function p = drawn (m, t, q, named)
  p = m.ske (t, q);
  if (! isempty (named))
    p = [p, m.pnt(t, q)];
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

function names = heads (m, named)
  skeleton = m.skeleton;
  names = {"t"};
  for b = 1:numel (skeleton.body)
    for k = 1:skeleton.points(b)
      names = [names, ...
               cellfun(@(c) sprintf ("%s.%d.%s", skeleton.body{b}, k, c), {"x", "y", "z"}, ...
                       "UniformOutput", false)];
    endfor
  endfor
  for part = skeleton.parts
    for k = 1:numel (part.bodies)
      names = [names, ...
               cellfun(@(c) sprintf ("%s.%d.%s", part.name, k, c), {"x", "y", "z"}, ...
                       "UniformOutput", false)];
    endfor
  endfor
  for k = 1:numel (named)
    names = [names, cellfun(@(c) [m.points{k} "." c], {"x", "y", "z"}, "UniformOutput", false)];
  endfor
endfunction

## ------------------------------------------------------------ where it stands

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
%!error <option times must lie within the result, from 0 to 1 s, found >
%! [m, r] = pendulum (0); gsmbp_animate (m, r, "a.png", "times", 2)
%!error <no link "rod"; known: upper, lower>
%! [m, r] = pendulum (0); gsmbp_animate (m, r, "a.png", "trace", "rod")
%!error <a column of m.ske, 1 to 6> [m, r] = pendulum (0); gsmbp_animate (m, r, "a.png", "trace", 7)
