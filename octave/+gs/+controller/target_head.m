## lines = gs.controller.target_head (c, t, mark)
## What the comment ahead of a controller of gsmbp_model_control alone says, lines behind a MARK; T:
## of gs.controller.target_files.

function lines = target_head (c, t, mark)
  said = {sprintf("Z (%d), inout: memory (%d), then constants of the scene", t.nz + t.cst, ...
                  t.nz), "T: time [s]", ...
          ["It calculates with the equations of the scene " t.name "."]};
  if (isfield (c, "through"))
    said{end+1} = sprintf (["Number %d of Z counts samples without a command: U stays as it " ...
                            "was, the loops do not close or the drives cannot give the " ...
                            "motion."], t.nz);
  endif
  lines = gs.controller.head_lines (c, c.name, mark, said);
endfunction
