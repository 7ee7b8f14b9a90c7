## gsmbp__all_failed (who, m, ok, reason)
## A warning of WHO where of many runs of the model M not one is OK, with the first REASON.

function gsmbp__all_failed (who, m, ok, reason)
  if (! isempty (ok) && ! any (ok))
    warning ("gsmbp:failed", "%s: %s: all %d runs failed, run 1: %s", who, m.name, numel (ok), ...
             reason{1});
  endif
endfunction
