## [factor, powers, unknown] = gsmbp__unit (text)
## A unit written as "N*m/A", "kg*cm^2", "rpm": its factor to SI units and the powers of kg, m, s,
## A, K; UNKNOWN: the first word that is no unit, empty where all is well.

function [factor, powers, unknown] = gsmbp__unit (text)
  [factor, powers, unknown] = deal (1, zeros (1, 5), "");
  [pieces, signs] = strsplit (text, {"*", "/"});
  for k = 1:numel (pieces)
    [one, power, unknown] = piece (strtrim (pieces{k}));
    if (! isempty (unknown))
      return;
    endif
    if (k > 1 && strcmp (signs{k-1}, "/"))
      power = -power;
    endif
    factor *= one.factor ^ power;
    powers += one.powers * power;
  endfor
endfunction

## a word of the table and its power, "cm^2"
function [one, power, unknown] = piece (text)
  [one, power, unknown] = deal ([], 1, "");
  [word, rest] = strtok (text, "^");
  if (! isempty (rest))
    power = str2double (rest(2:end));
  endif
  table = units ();
  k = find (strcmp (word, table(:,1)), 1);
  if (isempty (k) || ! (isfinite (power) && power == fix (power)))
    unknown = text;
    if (isempty (unknown))
      unknown = "nothing";
    endif
    return;
  endif
  one = struct ("factor", table{k,2}, "powers", table{k,3});
endfunction

## word, factor, powers of kg, m, s, A, K
function table = units ()
  number = [0 0 0 0 0];
  mass = [1 0 0 0 0];
  way = [0 1 0 0 0];
  time = [0 0 1 0 0];
  force = [1 1 -2 0 0];
  torque = [1 2 -2 0 0];
  table = {"1", 1, number; "rad", 1, number; "rev", 2*pi, number; "deg", pi/180, number
           "%", 0.01, number
           "kg", 1, mass; "g", 1e-3, mass; "gram", 1e-3, mass; "tonne", 1e3, mass
           "lb", 0.45359237, mass
           "m", 1, way; "cm", 1e-2, way; "mm", 1e-3, way; "um", 1e-6, way; "inch", 0.0254, way
           "s", 1, time; "ms", 1e-3, time; "us", 1e-6, time; "min", 60, time; "hour", 3600, time
           "rpm", 2*pi/60, -time; "Hz", 1, -time
           "N", 1, force; "kN", 1e3, force; "MN", 1e6, force; "mN", 1e-3, force
           "Nm", 1, torque; "mNm", 1e-3, torque; "Nmm", 1e-3, torque; "Ncm", 1e-2, torque
           "J", 1, torque; "kJ", 1e3, torque; "W", 1, [1 2 -3 0 0]; "kW", 1e3, [1 2 -3 0 0]
           "Pa", 1, [1 -1 -2 0 0]; "kPa", 1e3, [1 -1 -2 0 0]; "MPa", 1e6, [1 -1 -2 0 0]
           "bar", 1e5, [1 -1 -2 0 0]; "l", 1e-3, 3*way
           "A", 1, [0 0 0 1 0]; "mA", 1e-3, [0 0 0 1 0]
           "V", 1, [1 2 -3 -1 0]; "mV", 1e-3, [1 2 -3 -1 0]; "kV", 1e3, [1 2 -3 -1 0]
           "ohm", 1, [1 2 -3 -2 0]; "mohm", 1e-3, [1 2 -3 -2 0]
           "H", 1, [1 2 -2 -2 0]; "mH", 1e-3, [1 2 -2 -2 0]; "uH", 1e-6, [1 2 -2 -2 0]
           "K", 1, [0 0 0 0 1]};
endfunction
