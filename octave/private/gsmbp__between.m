## list = gsmbp__between (skeleton, p)
## The parts of the skeleton that stand between its bodies, for gsmbp__symbol: kind, columns in the
## points P (3 x columns x poses), bodies (numbers, one for each point), color, least and largest
## (length in these poses [m]), beside (-1, 0, 1: to which side of the line where two of them have
## the same ends).

function list = gsmbp__between (skeleton, p)
  list = struct ("kind", {}, "columns", {}, "bodies", {}, "color", {}, "least", {}, "largest", ...
                 {}, "beside", {});
  column = sum (skeleton.points);
  for part = skeleton.parts
    [~, bodies] = ismember (part.bodies, skeleton.body);
    one = struct ("kind", gsmbp__part_kind (part.kind), "columns", ...
                  column + (1:numel (bodies)), "bodies", bodies, "color", "#444444", "least", 0, ...
                  "largest", 0, "beside", 0);
    column += numel (bodies);
    if (strcmp (one.kind, "disc"))
      one.color = skeleton.color{bodies(1)};
    else
      long = sqrt (sumsq (diff (p(:,one.columns,:), 1, 2), 1));
      [one.least, one.largest] = deal (min (long), max (long));
      for k = find (arrayfun (@(x) same_ends (p, x.columns, one.columns), list))
        [list(k).beside, one.beside] = deal (-1, 1);
      endfor
    endif
    list(end+1) = one;
  endfor
endfunction

function yes = same_ends (p, a, b)
  yes = numel (a) == 2 && any (cellfun (@(b) max (max (abs (p(:,a,1) - p(:,b,1)))) < 1e-9, ...
                                        {b, flip(b)}));
endfunction
