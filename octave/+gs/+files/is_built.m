## [yes, key] = gs.files.is_built (target, flags, sources)
## Whether the file TARGET is there as gs.files.build_once made it with these FLAGS of these
## contents of the SOURCES; KEY: a sum of both.  Times in whole seconds would not tell what was
## edited in the second of a build; a module that is cut short would end Octave when it is loaded.

function [yes, key] = is_built (target, flags, sources)
  sums = gs.files.sums_of (sources(:));
  key = hash ("md5", sprintf ("%s\n", flags, sums{:}));
  said = [target ".md5"];
  yes = ! isempty (stat (target)) && ! isempty (stat (said));
  if (yes)
    own = gs.files.sums_of ({target});
    yes = strcmp (fileread (said), [own{1} " " key "\n"]);
  endif
endfunction
