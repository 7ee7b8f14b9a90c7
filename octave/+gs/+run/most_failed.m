## gs.run.most_failed (who, m, ok, reason)
## A warning of WHO where of many runs of the model M half or more are not OK, with the first
## REASON.

function most_failed (who, m, ok, reason)
  first = find (! ok, 1);
  if (isempty (first) || 2 * nnz (! ok) < numel (ok))
    return;
  elseif (! any (ok))
    warning ("gsmbp:failed", "%s: %s: all %d runs failed, run 1: %s", who, m.name, numel (ok), ...
             reason{1});
  else
    warning ("gsmbp:failed", "%s: %s: %d of %d runs failed, the first of them run %d: %s", who, ...
             m.name, nnz (! ok), numel (ok), first, reason{first});
  endif
endfunction
