## text = gsmbp__machine_corner (d, k)
## Corner K of the design D in words: m3 +10 %, motor_K -5 %.

function text = gsmbp__machine_corner (d, k)
  list = d.asked.tolerances;
  parts = arrayfun (@(i) sprintf ("%s %+.3g %%", list{i,1}, ...
                                  100 * d.corners(k).signs(i) * list{i,2}), 1:rows (list), ...
                    "UniformOutput", false);
  text = strjoin (parts, ", ");
endfunction
