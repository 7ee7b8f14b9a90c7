## order = gs.drive.rank_choices (found, goal)
## Numbers of the feasible ones of FOUND, by their field GOAL, then by name.

function order = rank_choices (found, goal)
  order = find ([found.feasible]);
  [~, by_name] = sort ({found(order).name});
  order = order(by_name);
  [~, by_goal] = sort ([found(order).(goal)]);
  order = order(by_goal);
endfunction
