## [label, factor] = gs.text.axis_label (unit, y, rows)
## Quantity and unit of an axis for numbers Y in a UNIT in SI, with a prefix where they are large or
## small, and what they are multiplied by.  ROWS: of gs.model.name_table.

function [label, factor] = axis_label (unit, y, rows)
  quantities = {"rad", "angle"; "m", "position"; "rad/s", "angular speed"; "m/s", ...
      "speed"; "A", "current"
                "V", "voltage"; "N", "force"; "N*m", "torque"; "Pa", "pressure"; "W", "power"
                "J", "energy"; "K", "temperature"; "m^3/s", "flow"; "Wb", ...
                    "flux"; "kg/s", "mass flow"
                "rad/s^2", "angular acceleration"; "m/s^2", "acceleration"; "kg", "mass"
                "m^2", "area"; "m^3", "volume"; "s", "time"; "Hz", "frequency"; "C", "charge"};
  k = find (strcmp (quantities(:,1), unit));
  if (! isempty (k))
    quantity = quantities{k,2};
  elseif (all (strcmp ({rows.kind}, "margin")))
    quantity = "margin";
  else
    quantity = strjoin ({rows.name}, ", ");
  endif
  if (numel (rows) == 1 && ! strcmp (quantity, rows.name))
    quantity = [quantity " " rows.name];
  endif
  factor = 1;
  written = unit;
  with_prefix = {"m", "rad", "m/s", "rad/s", "A", "V", "N", "N*m", "Pa", "W", "J", "s", "Hz", ...
                 "C", "Wb"};
  if (any (strcmp (unit, with_prefix)))
    [prefix, factor] = prefix_of (max (abs (y(isfinite (y)))));
    written = [prefix written];
  endif
  if (any (strcmp (unit, {"", "1"})))
    label = quantity;
  else
    label = sprintf ("%s [%s]", quantity, written);
  endif
endfunction

## so that the largest number is from 1 to 1000; between 0.1 and 1000 as it is
function [prefix, factor] = prefix_of (largest)
  [prefix, factor] = deal ("", 1);
  if (isempty (largest) || largest == 0 || (largest >= 0.1 && largest < 1000))
    return;
  endif
  prefixes = {"n", "u", "m", "", "k", "M", "G"};
  k = min (3, max (-3, floor (log10 (largest) / 3 + 1e-12)));
  [prefix, factor] = deal (prefixes{k + 4}, 10 ^ (-3 * k));
endfunction
