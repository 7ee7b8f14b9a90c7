## [text, unit] = gs.text.rest_names (p)
## Names and units of the equations of the problem P.

function [text, unit] = rest_names (p)
  [m, d] = deal (p.m, p.m.sizes);
  text = [strcat({"rate of "}, m.coordinates(:)); strcat({"acceleration of "}, m.speeds(:)); ...
          strcat({"rate of "}, m.states(d.nq + d.nu + 1:d.nx)(:))](p.rows(:));
  unit = regexprep (strcat (m.units.states(p.rows)(:), "/s"), "/s/s$", "/s^2");
  for k = 1:d.nlam
    text{end+1,1} = ["constraint " m.multipliers{k}];
    unit{end+1,1} = strtrim (gs.text.constraint_unit (m, k));
  endfor
  for k = 1:d.nlam * ! isempty (p.steady)
    text{end+1,1} = ["rate of constraint " m.multipliers{k}];
    unit{end+1,1} = [strtrim(gs.text.constraint_unit (m, k)) "/s"];
  endfor
  for k = 1:rows (m.orientation)
    text{end+1,1} = ["norm of " m.states{m.orientation(k,1)} " .. " m.states{m.orientation(k,4)}];
    unit{end+1,1} = "1";
  endfor
endfunction
