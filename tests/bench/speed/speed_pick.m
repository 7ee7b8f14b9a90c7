## one = speed_pick (list, who, mode, word): the entries of a struct array with these fields; ""
## takes any mode.

function one = speed_pick (list, who, mode, word)
  one = [];
  if (! isempty (list))
    one = list(strcmp ({list.who}, who) & (strcmp ({list.mode}, ...
                   mode) | isempty (mode)) & strcmp ({list.word}, word));
  end
end
