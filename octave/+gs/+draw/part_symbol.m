## pieces = gs.draw.part_symbol (one, q, s)
## The lines and areas that draw ONE part (of gs.draw.parts_between) with its points Q on the stage
## S, a struct array: points, style of gnuplot's lines, filled, color, tint (1: the colour itself).

function pieces = part_symbol (one, q, s)
  if (strcmp (one.kind, "disc"))
    rim = gs.draw.disc_rim (q);
    pieces = [piece(rim, "", one.color, 0.2), piece(rim, "lines lw 3", one.color, 1), ...
              piece(q(:,[1, 3]), "lines lw 1.5", one.color, 1)];
    return;
  endif
  along = q(:,2) - q(:,1);
  long = norm (along);
  if (! (long > 0))
    pieces = piece (zeros (3, 0), "lines", one.color, 1);
    return;
  endif
  e = along / long;
  wide = 0.45 * s.mark;
  n = across (e, s);
  at = @(x, y) q(:,1) + e * x + n * (y * wide + one.beside * 1.2 * wide);
  switch (one.kind)
    case "cylinder"
      pieces = cylinder (at, long, one);
    case "spring"
      pieces = spring (at, long, one);
    otherwise
      pieces = damper (at, long, one);
  endswitch
  if (one.beside != 0)
    ends = [q(:,1), at(0, 0), NaN(3, 1), q(:,2), at(long, 0)];
    pieces = [pieces, piece(ends, "lines lw 1.5", one.color, 1)];
  endif
  pieces(end+1) = piece (q, "points pt 7 ps 0.6", one.color, 1);
endfunction

function one = piece (points, style, color, tint)
  one = struct ("points", points, "style", style, "filled", isempty (style), "color", color, ...
                "tint", tint);
endfunction

## a direction across the line that is seen at its full length
function n = across (e, s)
  if (numel (s.axes) == 2)
    n = zeros (3, 1);
    n(s.axes) = [-e(s.axes(2)); e(s.axes(1))];
  else
    n = cross (s.eye, e);
  endif
  if (norm (n) < 1e-6)
    n = zeros (3, 1);
    n(s.axes(end)) = 1;
  endif
  n /= norm (n);
endfunction

## housing with piston and rod
function list = cylinder (at, long, one)
  [back, front, piston] = gs.draw.cylinder_housing (one, long);
  box = [at(back, -1), at(back, 1), at(front, 1), at(front, -1), at(back, -1)];
  list = [piece(box, "", one.color, 0.3), ...
          piece([at(piston, -1), at(piston, 1)], "lines lw 3", one.color, 1), ...
          piece([at(piston, 0), at(long, 0)], "lines lw 2.5", one.color, 1), ...
          piece(box, "lines lw 1.5", one.color, 1)];
endfunction

function list = spring (at, long, one)
  x = [0, 0.12 + 0.76 * ((0:16) / 16), 1] * long;
  y = [0, 0, repmat([1, 0, -1, 0], 1, 4), 0];
  list = piece (cell2mat (arrayfun (at, x, y, "UniformOutput", false)), "lines lw 1.5", ...
                one.color, 1);
endfunction

## a cup with a plate in it
function list = damper (at, long, one)
  [from, to] = deal (0.35 * long, 0.65 * long);
  gap = NaN (3, 1);
  lines = [at(0, 0), at(from, 0), gap, at(to, 0.7), at(from, 0.7), at(from, -0.7), at(to, -0.7)];
  plate = [at(0.5 * long, -0.5), at(0.5 * long, 0.5), gap, at(0.5 * long, 0), at(long, 0)];
  list = [piece(lines, "lines lw 1.5", one.color, 1), ...
          piece(plate, "lines lw 1.5", one.color, 1)];
endfunction
