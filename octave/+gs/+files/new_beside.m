## new = gs.files.new_beside (who, file)
## The name NEW next to FILE under which its content is made before gs.files.rename_new puts it in
## place; a symbolic link is followed.  The folder is made if it is not there; parts that killed
## processes left in it are removed.  FILE has to be a regular file or a new name, else it is an
## error of WHO.

function new = new_beside (who, file)
  target = file;
  [link, failed] = lstat (file);
  if (! failed && S_ISLNK (link.mode))
    target = canonicalize_file_name (file);
  endif
  there = stat (file);
  if (! failed && isempty (there))
    refuse (who, file, "a symbolic link to nothing");
  elseif (! isempty (there) && S_ISDIR (there.mode))
    refuse (who, file, "a folder");
  elseif (! isempty (there) && ! S_ISREG (there.mode))
    refuse (who, file, "a device, pipe or socket");
  endif
  [folder, name, kind] = fileparts (target);
  gs.files.make_folder (who, folder);
  sweep (folder);
  new = fullfile (folder, sprintf (".new-%d-%s%s", getpid (), name, kind));
endfunction

function refuse (who, file, found)
  error (["%s: %s: expected a regular file or a new name; found %s; give the name of a regular " ...
          "file or a new name"], who, file, found);
endfunction

## parts of processes that are no more: kill with signal 0 says so
function sweep (folder)
  for part = glob (fullfile (folder, ".new-*"))'
    pid = str2double (regexp (part{1}, '\.new-(\d+)-[^/]*$', "tokens", "once"));
    if (isscalar (pid) && kill (pid, 0) < 0 && ! exist (sprintf ("/proc/%d", pid), "dir"))
      gs.files.discard_file (part{1});
    endif
  endfor
endfunction
