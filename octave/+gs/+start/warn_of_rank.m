## gs.start.warn_of_rank (who, m, t, x, refusal)
## A warning of WHO if constraints of the model M that are independent elsewhere are not so in the
## state X at the time T; REFUSAL: the row of gsmbp/refusals.h that says what this means.

function warn_of_rank (who, m, t, x, refusal)
  if (m.sizes.nlam == 0)
    return;
  endif
  text = m.module ("lost rank", m.cst, gs.model.parameter_values (m), t, x, m.nominal, ...
                   gs.start.general_rank (m), m.initial);
  if (! isempty (text))
    warning ("gsmbp:singular", "%s: %s: at this position %s: %s", who, m.name, text, ...
             gs.text.refusal_text (refusal));
  endif
endfunction
