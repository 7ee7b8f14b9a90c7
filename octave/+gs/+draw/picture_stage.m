## s = gs.draw.picture_stage (p, path, o, entries, letters)
## What all pictures share: the projection of the points P, axes, sizes, legend.

function s = picture_stage (p, path, o, entries, letters)
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
