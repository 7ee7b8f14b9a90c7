## yes = gsmbp__older (target, sources)
## True if TARGET does not exist, is older than any file of the cell array SOURCES, or is not
## what gsmbp__put_in_place left: a module that is cut short would end Octave when it is loaded.

function yes = gsmbp__older (target, sources)
  t = stat (target);
  if (isempty (t))
    yes = true;
    return;
  endif
  times = cellfun (@(f) stat (f).mtime, sources);
  yes = any (times > t.mtime) || ! intact (target);
endfunction

function yes = intact (target)
  sum_ = [target ".md5"];
  yes = exist (sum_, "file") && strcmp (strtrim (fileread (sum_)), hash ("md5", fileread (target)));
endfunction
