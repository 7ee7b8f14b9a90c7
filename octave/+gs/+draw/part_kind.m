## word = gs.draw.part_kind (kind)
## As what an element of the scene that stands between two points, or rolls, is drawn.

function word = part_kind (kind)
  switch (kind)
    case {"spring", "damper"}
      word = kind;
    case "rolling"
      word = "disc";
    otherwise
      word = "cylinder";   # a device that pushes or pulls
  endswitch
endfunction
