## [c, n, loop] = speed_operations (file): mul add div sqrt trig of the text of the routines inv mas
## fwd lin, and of jac with its loops and calls, in the description FILE of a scene, its speeds, and
## whether it has loops.

function [c, n, loop] = speed_operations (file)
  d = jsondecode (fileread (file));
  n = d.dimensions.nu;
  loop = d.dimensions.nlam > 0;
  c = struct ();
  list = d.subroutines;
  if (isstruct (list))
    list = num2cell (list);
  end
  for word = {"inv", "mas", "fwd", "lin", "jac"}
    is_it = cellfun (@(s) strcmpi (s.name, [d.name "_" word{1}]), list);
    if (strcmp (word{1}, "fwd") && d.dimensions.nlam > 0)
      ## forward dynamics of the loop
      is_it = cellfun (@(s) strcmpi (s.name, [d.name "_acc"]), list);
    end
    if (any (is_it))
      o = list{is_it}.([{"own_", ""}{1 + strcmp(word{1}, "jac")} "operations"]);
      c.(word{1}) = [o.mul o.add o.div o.sqrt o.trig];
    end
  end
end
