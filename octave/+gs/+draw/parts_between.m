## list = gs.draw.parts_between (skeleton, p)
## The parts of the skeleton that stand between its bodies, for gs.draw.part_symbol: kind, columns
## in the points P (3 x columns x poses), bodies (numbers, one for each point), color, least and
## largest (length in these poses [m]), beside (-1, 0, 1: to which side of the line where two of
## them have the same ends in all poses).

function list = parts_between (skeleton, p)
  list = struct ("kind", {}, "columns", {}, "bodies", {}, "color", {}, "least", {}, "largest", ...
                 {}, "beside", {});
  column = sum (skeleton.points);
  for part = skeleton.parts
    list(end+1) = one_part (skeleton, part, column, p);
    column += numel (list(end).bodies);
  endfor
  lines = find (! strcmp ({list.kind}, "disc"));
  for k = lines
    for j = lines(lines < k)
      if (same_ends (p(:,list(j).columns,:), p(:,list(k).columns,:)))
        [list(j).beside, list(k).beside] = deal (-1, 1);
      endif
    endfor
  endfor
endfunction

## with its points in the columns of P behind COLUMN
function one = one_part (skeleton, part, column, p)
  [~, bodies] = ismember (part.bodies, skeleton.body);
  one = struct ("kind", gs.draw.part_kind (part.kind), "columns", column + (1:numel (bodies)), ...
                "bodies", bodies, "color", "#444444", "least", 0, "largest", 0, "beside", 0);
  if (strcmp (one.kind, "disc"))
    one.color = skeleton.color{bodies(1)};
    return;
  endif
  long = sqrt (sumsq (diff (p(:,one.columns,:), 1, 2), 1));
  [one.least, one.largest] = deal (min (long(:)), max (long(:)));
endfunction

## whether two pairs of points are at the same places in all poses, in one order or the other
function yes = same_ends (a, b)
  apart = @(b) max (abs (a - b)(:));
  yes = columns (a) == 2 && columns (b) == 2 && min (apart (b), apart (flip (b, 2))) < 1e-9;
endfunction
