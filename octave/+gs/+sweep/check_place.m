## gs.sweep.check_place (who, folder, told)
## An error of WHO unless FOLDER can take the program of the sweep that TOLD
## (gs.sweep.describe_sweep) tells of: one that is new, empty or of such a program, without runs of
## another sweep.

function check_place (who, folder, told)
  if (exist (folder, "file") == 2)
    error ("%s: option program: %s is a file", who, folder);
  elseif (! exist (folder, "dir"))
    return;
  endif
  names = setdiff ({dir(folder).name}, {".", ".."});
  if (isempty (names))
    return;
  elseif (! is_job (fullfile (folder, "sweep.job")))
    error (["%s: option program: expected a folder that is empty, new or of a sweep, found %s " ...
            "with %s"], who, folder, names{1});
  endif
  table = fullfile (folder, "sweep.h5");
  parts = fullfile (folder, "sweep.h5.parts", "sweep.txt");
  if (exist (table, "file"))
    gs.sweep.check_same (who, table, gs.sweep.read_description (who, "program", table), told);
  elseif (exist (parts, "file"))
    gs.sweep.check_same (who, fileparts (parts), fileread (parts), told);
  endif
endfunction

## does a file begin as a job does (gs.sweep.record_names)?
function is = is_job (file)
  is = false;
  f = fopen (file, "r");
  if (f >= 0)
    is = isequal (fread (f, 14, "char=>char")', "description s ");
    fclose (f);
  endif
endfunction
