## limits = gsmbp__limits (who, m, o, n)
## The limits of gsmbp_retime as rows [least, largest]: speed and effort of N coordinates, input.

function limits = gsmbp__limits (who, m, o, n)
  limits = struct ();
  sizes = struct ("speed", n, "effort", n, "input", m.sizes.nv);
  for name = fieldnames (sizes)'
    limits.(name{1}) = gsmbp__bounds (who, ["limit " name{1}], o.(name{1}), ...
                                        sizes.(name{1}));
  endfor
  if (isempty (o.speed) && isempty (o.effort) && isempty (o.input))
    error ("%s: expected a limit: speed, effort or input", who);
  endif
  if (! isempty (o.input) && ! any (strcmp (m.subroutines, "cmq")) && m.order > 2)
    error ("%s: limits of the inputs need the subroutine CMQ, which %s has not: %s", ...
        who, m.name, ...
           gsmbp__why_left_out (m, "quasi_static"));
  endif
endfunction
