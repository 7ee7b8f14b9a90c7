## lines = gsmbp__picture (skeleton, p, shades, path, s, title, o)
## The lines of gnuplot that draw one picture.

function lines = gsmbp__picture (skeleton, p, shades, path, s, title, o)
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
  d = all_named (d, p(:,:,end), skeleton.marks.labels, s);
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
