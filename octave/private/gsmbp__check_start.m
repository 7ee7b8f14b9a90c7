## gsmbp__check_start (who, m, x, fault)
## Calls FAULT (a function of a printed text) if a device cannot be where the states X
## of the model M say: a margin of the device, in its states and parameters, is below 0,
## however the states are moved by 1e-6 of their usual sizes.

function gsmbp__check_start (who, m, x, fault)
  if (! isfield (m, "json"))
    return;
  endif
  for row = gsmbp__rows (m.json, "start_margins")
    k = double (row{1}.states(:));
    value = gsmbp__value (m, row{1}, x(k));
    if (isreal (value) && value < 0 && ! near (m, row{1}, x(k), 1e-6 * m.nominal(k)))
      fault (sprintf ("%s: %s: %s: expected %s; found %s", who, m.name, row{1}.place, ...
                      row{1}.text, found (m, row{1}, x(k), k)));
    endif
  endfor
endfunction

function yes = near (m, row, x, steps)
  yes = false;
  for k = 1:numel (x)
    for side = [-1, 1]
      y = x;
      y(k) += side * steps(k);
      yes |= gsmbp__value (m, row, y) >= 0;
    endfor
  endfor
endfunction

function text = found (m, row, x, k)
  pairs = arrayfun (@(i) sprintf ("%s = %.6g", m.states{k(i)}, x(i)), 1:numel (k), ...
                    "UniformOutput", false);
  if (! isempty (row.parameters))
    pairs = [pairs, cellfun(@(name) sprintf ("%s = %.6g", name, m.par.(name)), ...
                            cellstr (row.parameters)(:)', "UniformOutput", false)];
  endif
  text = strjoin (pairs, ", ");
endfunction
