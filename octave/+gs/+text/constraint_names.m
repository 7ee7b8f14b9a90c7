## label = gs.text.constraint_names (m)
## A name for each constraint of the model M: that of its multiplier.

function label = constraint_names (m)
  label = arrayfun (@(k) sprintf ("phi(%d)", k), (1:m.sizes.nlam)', "UniformOutput", false);
  if (numel (m.multipliers) == m.sizes.nlam)
    label = m.multipliers(:);
  endif
endfunction
