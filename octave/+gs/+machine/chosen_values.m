## values = gs.machine.chosen_values (m, axes_, drives, chosen)
## The parameters of the model M that the choice sets: for axis j the pair
## drives(j).pairs(chosen(j)).

function values = chosen_values (m, axes_, drives, chosen)
  values = struct ();
  for j = 1:numel (axes_)
    d = drives(j).pairs(chosen(j)).device;
    to = axes_(j).par;
    [values.(to.R), values.(to.L), values.(to.K), values.(to.B), values.(to.n)] = ...
        deal (d.R, d.L, d.K, d.B, d.ratio);
    if (isempty (to.Jg))
      values.(to.J) = d.J;
    else
      [values.(to.J), values.(to.Jg)] = deal (d.Jm, d.J_in);
    endif
    if (! isempty (to.eta))
      values.(to.eta) = d.eta;
    endif
    if (isfield (m.par, to.Tc) && d.tc > 0)
      values.(to.Tc) = d.tc;
    endif
  endfor
endfunction
