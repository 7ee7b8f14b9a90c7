## yes = gsmbp__older (target, sources)
## True if TARGET does not exist or is older than any file of the cell array
## SOURCES.

function yes = gsmbp__older (target, sources)
  t = stat (target);
  if (isempty (t))
    yes = true;
    return;
  endif
  times = cellfun (@(f) stat (f).mtime, sources);
  yes = any (times > t.mtime);
endfunction
