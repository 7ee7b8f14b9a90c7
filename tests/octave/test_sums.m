## What gsmbp_build takes as the contents of files (gs.files.sums_of), which a session reads once:
## every change is seen, in the second of a look, with the old size and time, by another file of the
## name; one that is gone is an error.

function test_sums ()
  folder = tempname ();
  mkdir (folder);
  gone = onCleanup (@() remove (folder));
  file = fullfile (folder, "a");
  other = fullfile (folder, "b");
  puts_text (file, "one");
  puts_text (other, "other");
  gsmbp_check ("the sum is MD5's", isequal (gs.files.sums_of ({file; file}), ...
                                            {hash("md5", "one"); hash("md5", "one")}));
  puts_text (file, "two");
  gsmbp_check ("changed in the second of a look", isequal (last_of ({other; file}), ...
                                                           hash ("md5", "two")));
  system (sprintf ("touch -d '1 hour ago' '%s' '%s'", file, other));
  pause (4);   # times of files that are older than that tell of every change
  last_of ({other; file});
  system (sprintf ("cp -p '%s' '%s.old' && printf six >'%s' && touch -r '%s.old' '%s'", file, ...
                   file, file, file, file));
  gsmbp_check ("changed with its old size and time", isequal (last_of ({other; file}), ...
                                                              hash ("md5", "six")));
  pause (4);
  last_of ({file});
  system (sprintf ("mv '%s.old' '%s'", file, file));
  gsmbp_check ("another file of that name", isequal (last_of ({file}), hash ("md5", "two")));
  delete (file);
  said = gsmbp_complaint (@() gs.files.sums_of ({other; file}));
  gsmbp_check (["one that is gone: " said], ! isempty (strfind (said, "cannot open file")));
end

function text = last_of (files)
  sums = gs.files.sums_of (files);
  text = sums{end};
end

function puts_text (file, text)
  fid = fopen (file, "w");
  fputs (fid, text);
  fclose (fid);
end

function remove (folder)
  confirm_recursive_rmdir (false, "local");
  rmdir (folder, "s");
end
