## j = gsmbp__sweep_journal (who, m, o, told, records)
## The folder beside the file of a sweep, O.file with ".parts", where its finished chunks are: a
## struct with CALL (gsmbp__sweep_files), FOLDER, JOB, and DONE, whether the file is finished.  One
## of another sweep than TOLD is an error, as is one that is there and O.resume is false.

function j = gsmbp__sweep_journal (who, m, o, told, records)
  j.call = gsmbp__sweep_files (who, m);
  j.file = make_absolute_filename (o.file);
  j.folder = [j.file ".parts"];
  j.job = fullfile (j.folder, "sweep.job");
  j.done = exist (j.file, "file") == 2;
  if (exist (j.file, "dir"))
    error ("%s: option file: %s is a folder", who, o.file);
  elseif (j.done)
    found (who, o, o.file, "there is a file %s");
    same_sweep (who, o.file, description (who, o.file), told);
    return;
  endif
  said = fullfile (j.folder, "sweep.txt");
  if (exist (said, "file"))
    found (who, o, [o.file ".parts"], "a sweep was interrupted that left %s");
    same_sweep (who, [o.file ".parts"], fileread (said), told);
    gsmbp__write (who, j.job, gsmbp__sweep_job (records));   # the program keeps it elsewhere
    return;
  endif
  gsmbp__folder (who, fileparts (j.file));
  gsmbp__folder (who, j.folder);
  gsmbp__write (who, j.job, gsmbp__sweep_job (records));
  gsmbp__write (who, said, told);
endfunction

function found (who, o, place, what)
  if (! o.resume)
    error (["%s: " what "; \"resume\", true goes on with it if it is of the same sweep"], who, ...
           place);
  endif
endfunction

## what a finished table says of itself
function text = description (who, file)
  text = "";
  try
    w = load ("-hdf5", file);
    text = sprintf ("%s\n", cellstr (w.description){:});
  catch
    error ("%s: option file: %s is no table of a sweep", who, file);
  end_try_catch
endfunction

## the first line in which they differ
function same_sweep (who, place, there, here)
  if (numel (there) < numel (here) && strncmp (there, here, numel (there)))
    error ("%s: what %s says of its sweep is cut short: remove it to begin anew", who, place);
  endif
  [there, here] = deal (strsplit (there, "\n"), strsplit (here, "\n"));
  alone = {setdiff(there, here, "stable"), setdiff(here, there, "stable")};
  keys = cellfun (@(list) regexprep (list, ':.*', ''), alone, "UniformOutput", false);
  key = [keys{:}, {""}]{1};
  if (! isempty (key))
    said = cellfun (@(list, key_of) line_of (list(strcmp (key_of, key)), key), alone, keys, ...
                    "UniformOutput", false);
    error ("%s: %s is of another sweep: there %s, here %s", who, place, said{:});
  endif
endfunction

function text = line_of (lines, key)
  text = ["no " key];
  if (! isempty (lines))
    text = ["`" lines{1} "`"];
  endif
endfunction
