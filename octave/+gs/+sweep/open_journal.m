## j = gs.sweep.open_journal (who, m, o, told, records)
## The folder beside the file of a sweep, O.file with ".parts", where its finished chunks are: a
## struct with CALL (gs.sweep.file_functions), FOLDER, JOB, and DONE, whether the file is finished.
## One of another sweep than TOLD is an error, as is one that is there and O.resume is false.

function j = open_journal (who, m, o, told, records)
  j.call = gs.sweep.file_functions (who, m);
  j.file = make_absolute_filename (o.file);
  j.folder = [j.file ".parts"];
  j.job = fullfile (j.folder, "sweep.job");
  j.done = exist (j.file, "file") == 2;
  if (exist (j.file, "dir"))
    error ("%s: option file: %s is a folder", who, o.file);
  elseif (j.done)
    found (who, o, o.file, "there is a file %s");
    gs.sweep.check_same (who, o.file, gs.sweep.read_description (who, "file", o.file), told);
    return;
  endif
  said = fullfile (j.folder, "sweep.txt");
  if (exist (said, "file"))
    found (who, o, [o.file ".parts"], "a sweep was interrupted that left %s");
    gs.sweep.check_same (who, [o.file ".parts"], fileread (said), told);
    gs.files.write_text (who, j.job, gs.sweep.job_text (records)); ...
        # the program keeps it elsewhere
    return;
  endif
  folder = fileparts (j.file);
  if (! exist (folder, "dir"))
    error (["%s: option file: expected a file in a folder that exists; found no folder %s; " ...
            "make it with mkdir"], who, folder);
  endif
  gs.files.make_folder (who, j.folder);
  gs.files.write_text (who, j.job, gs.sweep.job_text (records));
  gs.files.write_text (who, said, told);
endfunction

function found (who, o, place, what)
  if (! o.resume)
    error (["%s: " what "; \"resume\", true goes on with it if it is of the same sweep"], who, ...
           place);
  endif
endfunction
