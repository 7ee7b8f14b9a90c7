## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {@var{list} =} gsmbp_catalogue (@var{kind})
## @deftypefnx {} {@var{list} =} gsmbp_catalogue (@var{kind}, @var{file})
## Read a catalogue of parts of drives.
##
## @var{kind}: @code{"motors"}, @code{"gears"}, @code{"screws"}, @code{"amplifiers"} or
## @code{"cylinders"}.  Without @var{file} these are the typical data that come with GSMBP
## (@file{share/catalogue/@var{kind}.csv}, no maker's); a file of one's own has the same form:
## lines that begin with @code{#} are remarks; the first other line has the heads of the columns,
## a name and its unit in brackets (@code{Jm [kg*cm^2]}, without brackets SI units); every further
## line is a part, its cells between commas.  The order of the columns does not matter; a cell
## that is empty, or a column that is not there, has the default.
##
## @var{list} is a struct array, a part each, with the field @code{name} and the numbers in SI
## units:
## @table @code
## @item "motors"
## R, L (default 0), Kt, Kb (Kt), Jm, bm (0), Tc (0), T_cont (rms), T_peak, omega_max,
## V_max, Rth (0), dT_max (100 K), mass, cost (0)
## @item "gears"
## ratio (motor : load), eta (the motor drives), eta_back (the load drives; default eta), J_in (at
## the input, 0), T_cont, T_peak (both at the output), omega_in_max, mass, cost
## @item "screws"
## lead (way in one turn), eta, eta_back (default eta; below 0 the screw locks itself and is driven
## down, too), J (0), F_cont, F_peak, omega_max (of the screw), d_root (of the thread; default
## infinite: not known), mass, cost
## @item "amplifiers"
## V_max, i_cont (rms), i_peak, mass, cost
## @item "cylinders"
## D (piston), d (rod), stroke, p_max, v_max (default infinite), mass, cost
## @end table
## Units are products and quotients of kg, g, m, cm, mm, s, ms, min, rad, deg, rev, rpm, Hz, N, kN,
## Nm, J, W, kW, Pa, kPa, MPa, bar, l, A, mA, V, ohm, H, mH, K, with whole powers.
##
## @c session octave
## @example
## >> motors = gsmbp_catalogue ("motors");
## >> numel (motors), motors(3).name, motors(3).T_cont
## ans = 8
## ans = S03
## ans = 0.6400
## @end example
##
## Errors: a file that cannot be read; a column that is missing, unknown or there twice, a unit of
## another quantity; a cell that is no number or out of its range, a line with another number of
## cells, a name that is there twice (file, line and column are said).
## Source: own.
## @seealso{gsmbp_drive, gsmbp_cylinder}
## @end deftypefn

function list = gsmbp_catalogue (kind, file)
  if (nargin < 1)
    print_usage ();
  endif
  who = "gsmbp_catalogue";
  gs.given.check_kind (who, "argument kind", kind, ...
                       {"motors", "gears", "screws", "amplifiers", "cylinders"});
  if (nargin < 2)
    file = gs.files.own_place ("share", "catalogue", [kind ".csv"]);
  endif
  gs.given.check_kind (who, "argument file", file, "text");
  [lines, numbers] = gs.text.csv_lines (who, file);
  if (isempty (lines))
    error ("%s: %s: expected a line with the heads of the columns, found none", who, file);
  endif
  fields = gs.drive.catalogue_fields (kind);
  [place, factor] = heads (who, file, numbers(1), lines{1}, fields);
  [list, names] = deal ([], {});
  for k = 2:numel (lines)
    part = read_part (who, sprintf ("%s: line %d", file, numbers(k)), lines{k}, place, factor, ...
                      fields);
    if (any (strcmp (names, part.name)))
      error ("%s: %s: line %d: the name %s is there twice", who, file, numbers(k), part.name);
    endif
    [list, names{end+1}] = deal ([list, part], part.name);
  endfor
  if (isempty (list))
    error ("%s: %s: expected a line for each part below the heads, found none", who, file);
  endif
endfunction

## the column of each field (the name first; 0: not there) and its factor to SI units
function [place, factor] = heads (who, file, number, line, fields)
  known = [{"name"}; fields(:,1)]';
  [place, factor] = deal (zeros (1, numel (known)), ones (1, numel (known)));
  [names, units] = gs.text.csv_heads (line);
  for c = 1:numel (names)
    at = sprintf ("%s: line %d, column %d", file, number, c);
    k = find (strcmp (known, names{c}));
    if (isempty (k))
      error ("%s: %s: unknown column %s", who, at, gs.text.nearest_word (names{c}, known));
    elseif (place(k) > 0)
      error ("%s: %s: the column %s is there twice", who, at, names{c});
    endif
    place(k) = c;
    if (! isempty (units{c}) && k > 1)
      factor(k) = unit_factor (who, sprintf ("%s, %s", at, names{c}), units{c}, fields{k-1,2});
    endif
  endfor
  needed = [true; cellfun(@(d) isnumeric (d) && isnan (d), fields(:,3))]';
  missing = known(needed & place == 0);
  if (! isempty (missing))
    error ("%s: %s: line %d: expected the columns %s, found %s", who, file, number, ...
           strjoin (missing, ", "), line);
  endif
endfunction

function factor = unit_factor (who, at, text, wanted)
  [factor, powers, unknown] = gs.text.unit_in_si (text);
  if (! isempty (unknown))
    error ("%s: %s: %s is no unit that is known; expected a unit like %s", who, at, unknown, ...
           wanted);
  endif
  [~, right] = gs.text.unit_in_si (wanted);
  if (! isequal (powers, right))
    error ("%s: %s: expected a unit like %s, found %s", who, at, wanted, text);
  endif
endfunction

function part = read_part (who, at, line, place, factor, fields)
  cells = strtrim (strsplit (line, ",", "CollapseDelimiters", false));
  if (numel (cells) != sum (place > 0))
    error ("%s: %s: expected %d cells, found %d", who, at, sum (place > 0), numel (cells));
  endif
  part.name = cells{place(1)};
  if (isempty (part.name))
    error ("%s: %s, column %d, name: expected a name, found nothing", who, at, place(1));
  endif
  for k = 1:rows (fields)
    [c, name] = deal (place(k+1), fields{k,1});
    if (c > 0 && ! isempty (cells{c}))
      value = str2double (cells{c}) * factor(k+1);
      in_range (who, sprintf ("%s (%s), column %d, %s", at, part.name, c, name), value, ...
                cells{c}, fields{k,4});
    elseif (ischar (fields{k,3}))
      value = part.(fields{k,3});
    else
      value = fields{k,3};
      if (isnan (value))
        error ("%s: %s (%s), column %d, %s: expected a number, found nothing", who, at, ...
               part.name, c, name);
      endif
    endif
    part.(name) = value;
  endfor
endfunction

function in_range (who, at, value, found, range)
  switch (range)
    case "positive"
      [fits, wanted] = deal (value > 0, "a number above 0");
    case "nonnegative"
      [fits, wanted] = deal (value >= 0, "a number >= 0");
    case "efficiency"
      [fits, wanted] = deal (value > 0 && value <= 1, "a number above 0, at most 1");
    case "back"
      [fits, wanted] = deal (value <= 1, "a number of at most 1");
  endswitch
  if (! (isreal (value) && isfinite (value) && fits))
    error ("%s: %s: expected %s, found %s", who, at, wanted, found);
  endif
endfunction

%!function list = read (kind, text)
%! file = [tempname() ".csv"];
%! f = fopen (file, "w");
%! fputs (f, text);
%! fclose (f);
%! guard = onCleanup (@() delete (file));
%! list = gsmbp_catalogue (kind, file);
%!endfunction
%!test <typical data>
%! for kind = {"motors", "gears", "screws", "amplifiers", "cylinders"}
%!   list = gsmbp_catalogue (kind{1});
%!   assert (numel (list) >= 8);
%!   assert (isempty (strfind ([list.name], " ")));
%! endfor
%! motors = gsmbp_catalogue ("motors");
%! assert ([motors(1).Jm, motors(1).omega_max, motors(1).L], [3.5e-6, 200*pi, 5.7e-4], 1e-12);
%! ## the winding is at its limit at the continuous torque
%! rise = [motors.Rth] .* [motors.R] .* ([motors.T_cont] ./ [motors.Kt]) .^ 2;
%! assert (all (rise > 85 & rise <= 100));
%!test <units, defaults, remarks, the order of columns>
%! g = read ("gears", ["# mine\n\nmass [g],name,ratio,eta [%],T_cont,T_peak [kN*cm],", ...
%!                     "omega_in_max [rpm]\r\n500,a b,5,96,3,0.2,60\n"]);
%! assert (g, struct ("name", "a b", "ratio", 5, "eta", 0.96, "eta_back", 0.96, "J_in", 0, ...
%!                    "T_cont", 3, "T_peak", 2, "omega_in_max", 2*pi, "mass", 0.5, "cost", 0));
%!error <line 1: expected the columns i_cont, i_peak, mass, found name,V_max>
%! read ("amplifiers", "name,V_max\n")
%!error <line 2, column 4: unknown column "i_peek", did you mean "i_peak"\?>
%! read ("amplifiers", "#\nname,V_max,i_cont,i_peek,mass\n")
%!error <line 1, column 3: the column V_max is there twice>
%! read ("amplifiers", "name,V_max,V_max,i_cont,i_peak,mass\n")
%!error <line 1, column 2, V_max: expected a unit like V, found A>
%! read ("amplifiers", "name,V_max [A],i_cont,i_peak,mass\n")
%!error <column 2, V_max: volt is no unit that is known; expected a unit like V>
%! read ("amplifiers", "name,V_max [volt],i_cont,i_peak,mass\n")
%!error <line 2: expected 5 cells, found 4>
%! read ("amplifiers", "name,V_max,i_cont,i_peak,mass\na,1,2,3\n")
%!error <line 2 \(a\), column 3, i_cont: expected a number above 0, found 2x>
%! read ("amplifiers", "name,V_max,i_cont,i_peak,mass\na,1,2x,3,0\n")
%!error <line 2 \(a\), column 5, mass: expected a number, found nothing>
%! read ("amplifiers", "name,V_max,i_cont,i_peak,mass\na,1,2,3,\n")
%!error <line 3: the name a is there twice>
%! read ("amplifiers", "name,V_max,i_cont,i_peak,mass\na,1,2,3,0\na,1,2,3,0\n")
%!error <expected a line for each part below the heads, found none>
%! read ("amplifiers", "name,V_max,i_cont,i_peak,mass\n")
%!error <cannot read no_such.csv> gsmbp_catalogue ("motors", "no_such.csv")
%!error <argument kind: expected one of "motors", "gears"> gsmbp_catalogue ("motor")
