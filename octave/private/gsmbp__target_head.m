## lines = gsmbp__target_head (c, t, mark)
## What the comment ahead of a controller of gsmbp_model_control alone says, lines behind a MARK; T:
## of gsmbp__target.

function lines = gsmbp__target_head (c, t, mark)
  said = {sprintf("Z (%d), inout: memory (%d), then constants of the scene", t.nz + t.cst, ...
                  t.nz), "T: time [s]", ...
          ["It calculates with the equations of the scene " t.name "."]};
  if (isfield (c, "through"))
    said{end+1} = sprintf (["Number %d of Z counts samples without a command: U stays as it " ...
                            "was, the loops do not close or the drives cannot give the " ...
                            "motion."], t.nz);
  endif
  lines = gsmbp__controller_head (c, c.name, mark, said);
endfunction
