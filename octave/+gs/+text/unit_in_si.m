## [factor, powers, unknown] = gs.text.unit_in_si (text)
## A unit written as "N*m/A", "kg*cm^2", "rpm": its factor to SI units and the powers of kg, m, s,
## A, K; UNKNOWN: the first word that is no unit, empty where all is well.

function [factor, powers, unknown] = unit_in_si (text)
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

## word, factor, powers of kg, m, s, A, K: the units of scenes (gsmbp/library/units.mac;
## tests/sh/units.sh holds them equal), and those that only tables have, where no parameter can be
## meant
function table = units ()
  persistent list = of_tables ();
  table = list;
endfunction

function table = of_tables ()
  table = [kinds([0 0 0 0 0], "rad", 1, "mrad", 1e-3, "urad", 1e-6, "deg", pi/180, ...
                 "arcmin", pi/10800, "arcsec", pi/648000, "rev", 2*pi, "turn", 2*pi, ...
                 "percent", 0.01, "%", 0.01, "1", 1)
           kinds([1 0 0 0 0], "kg", 1, "gram", 1e-3, "g", 1e-3, "mg", 1e-6, "tonne", 1e3, ...
                 "lb", 0.45359237)
           kinds([0 1 0 0 0], "m", 1, "km", 1e3, "cm", 1e-2, "mm", 1e-3, "um", 1e-6, "nm", 1e-9, ...
                 "inch", 0.0254, "foot", 0.3048)
           kinds([0 0 1 0 0], "s", 1, "ms", 1e-3, "us", 1e-6, "ns", 1e-9, "min", 60, ...
                 "hour", 3600, "day", 86400)
           kinds([0 0 -1 0 0], "Hz", 1, "kHz", 1e3, "MHz", 1e6, "GHz", 1e9, "rpm", pi/30)
           kinds([1 1 -2 0 0], "N", 1, "mN", 1e-3, "kN", 1e3, "MN", 1e6, "lbf", 4.4482216152605)
           kinds([1 2 -2 0 0], "J", 1, "mJ", 1e-3, "kJ", 1e3, "MJ", 1e6, "kWh", 3.6e6, ...
                 "Nm", 1, "mNm", 1e-3, "kNm", 1e3, "Nmm", 1e-3, "Ncm", 1e-2)
           kinds([1 2 -3 0 0], "W", 1, "mW", 1e-3, "kW", 1e3, "MW", 1e6)
           kinds([1 -1 -2 0 0], "Pa", 1, "hPa", 100, "kPa", 1e3, "MPa", 1e6, "GPa", 1e9, ...
                 "bar", 1e5, "mbar", 100, "psi", 8896443230521/129032*1e-4)
           kinds([0 3 0 0 0], "l", 1e-3)
           kinds([0 0 0 1 0], "A", 1, "nA", 1e-9, "uA", 1e-6, "mA", 1e-3, "kA", 1e3)
           kinds([1 2 -3 -1 0], "V", 1, "uV", 1e-6, "mV", 1e-3, "kV", 1e3)
           kinds([1 2 -3 -2 0], "ohm", 1, "uohm", 1e-6, "mohm", 1e-3, "kohm", 1e3, "Mohm", 1e6)
           kinds([1 2 -2 -2 0], "H", 1, "mH", 1e-3, "uH", 1e-6, "nH", 1e-9)
           kinds([-1 -2 4 2 0], "F", 1, "mF", 1e-3, "uF", 1e-6, "nF", 1e-9, "pF", 1e-12)
           kinds([0 0 1 1 0], "C", 1, "mC", 1e-3, "uC", 1e-6)
           kinds([1 0 -2 -1 0], "T", 1, "mT", 1e-3)
           kinds([1 2 -2 -1 0], "Wb", 1, "mWb", 1e-3)
           kinds([0 0 0 0 1], "K", 1, "mK", 1e-3)];
endfunction

## words and factors, all of the same powers
function list = kinds (powers, varargin)
  list = reshape (varargin, 2, [])';
  list(:,3) = {powers};
endfunction
