## gsmbp__no_jacobian (who, m)
## The error of WHO where the model M has no subroutine JAC: it says why, and what could help.

function gsmbp__no_jacobian (who, m)
  if (! isempty (m.events))
    error (["%s: %s has events (%s), where its rates jump: there is no Jacobian; derive it " ...
            "with smooth variants of these devices"], who, m.name, ...
           strjoin ({m.events.name}, ", "));
  endif
  error ("%s: %s was emitted without the subroutine JAC: add the request jacobian", who, m.name);
endfunction
