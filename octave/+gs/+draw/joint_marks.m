## m = gs.draw.joint_marks (skeleton, centres, named, links)
## The marks of joints and mass centres, and the key of what is drawn; labels of the points of the
## scene, NAMED, which stand behind those of the skeleton and its parts.

function m = joint_marks (skeleton, centres, named, links)
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
  m.key = [m.key, gs.draw.part_keys(skeleton.parts)];
  column += numel ([skeleton.parts.bodies]);
  m.labels = struct ("column", {}, "name", {}, "body", {});
  for k = find (! cellfun (@isempty, named(:)'))
    m.labels(end+1) = struct ("column", column + k, "name", named{k}, "body", ...
                              find (strcmp (skeleton.body, links{k})));
  endfor
endfunction
