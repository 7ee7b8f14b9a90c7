## q = gs.draw.seen_points (skeleton, p)
## All places (3 x any number) that the poses P of a skeleton take: its points, the rims of its
## discs in place of the points that tell them, and the housings of its cylinders.

function q = seen_points (skeleton, p)
  keep = true (1, columns (p));
  more = zeros (3, 0);
  for one = skeleton.between
    for k = 1:size (p, 3)
      own = p(:,one.columns,k);
      if (strcmp (one.kind, "disc"))
        keep(one.columns) = false;
        more = [more, gs.draw.disc_rim(own)];
      elseif (strcmp (one.kind, "cylinder") && norm (diff (own, 1, 2)) > 0)
        along = diff (own, 1, 2);
        more(:,end+1) = own(:,1) + along / norm (along) * gs.draw.cylinder_housing (one, ...
            norm (along));
      endif
    endfor
  endfor
  q = [reshape(p(:,keep,:), 3, []), more];
endfunction
