## text = gs.proof.corner_text (s, signs)
## The corner SIGNS of the tolerances of the specification S in words: m3 +10 %, motor_K -5 %.

function text = corner_text (s, signs)
  list = s.tolerances;
  parts = arrayfun (@(i) sprintf ("%s %+.3g %%", list{i,1}, ...
                                  100 * signs(i) * list{i,2}), 1:rows (list), ...
                    "UniformOutput", false);
  text = strjoin (parts, ", ");
endfunction
