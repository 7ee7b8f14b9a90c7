## loose = gs.start.warn_of_rank (who, m, t, x, refusal)
## A warning of WHO if constraints of the model M that are independent elsewhere are not so in the
## state X at the time T; REFUSAL: the row of gsmbp/refusals.h that says what this means.  LOOSE:
## a row, true for those whose multipliers nothing determines there.

function loose = warn_of_rank (who, m, t, x, refusal)
  loose = false (1, m.sizes.nlam);
  if (m.sizes.nlam == 0)
    return;
  endif
  [text, list] = m.module ("lost rank", m.cst, gs.model.parameter_values (m), t, x, m.nominal, ...
                   gs.start.general_rank (m), m.initial);
  loose = logical (list);
  if (! isempty (text))
    warning ("gsmbp:singular", "%s: %s: at this position %s: %s", who, m.name, text, ...
             gs.text.refusal_text (refusal));
  endif
endfunction
