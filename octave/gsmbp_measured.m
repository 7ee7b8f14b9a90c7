## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {@var{d} =} gsmbp_measured (@var{m}, @var{file}, @var{option}, @var{value}, @
## @dots{})
## @deftypefnx {} {@var{d} =} gsmbp_measured (@var{m}, @var{data}, @dots{})
## Measured motions and efforts of the open chain @var{m}, for @code{gsmbp_identify}.
##
## @var{file} is a table of numbers between commas; in its first line stand the heads of the
## columns, as @code{gsmbp_csv} writes them: @code{t}, the coordinates by their names (@code{q1}),
## speeds (@code{q1_d}) and accelerations (@code{q1_dd}) where they were measured, the efforts of
## the drives (@code{effort.q1}), each with its unit in brackets (@code{q1 [deg]}; without brackets
## SI units).  Other columns are left out.  @var{data}: a struct with the same as matrices, a row
## for each time: @code{t}, @code{q}, @code{tau}, and @code{u}, @code{ud} where they are known.
##
## Options:
## @table @code
## @item "columns"
## what the file calls them: names and heads in turn, @code{@{"q1", "pos1", "effort.q1", "M1"@}}
## @item "also"
## heads of further columns to keep (currents, voltages), as fields of @code{d.other}, their
## derivatives in @code{d.other_d}
## @item "cutoff", "order"
## frequency [Hz] and order (even, default 4) of a Butterworth filter that the motion passes forward
## and backward: no shift in time, half the amplitude at the cutoff.  It should be well above what
## moves: efforts are left as they are, @code{gsmbp_identify} filters both sides of its equations
## alike (option "decimate").  "auto": the cutoff with the least error of the accelerations, by the
## noise of the positions and what the filter takes from their smooth part; @code{d.cutoff} is it.
## "spline": no filter; positions, speeds and accelerations of a smooth spline through the
## positions, whose times need not be at equal distances
## @item "drop"
## seconds to leave out at both ends (default 1/cutoff, where a filter does not know what was
## before)
## @end table
## Speeds and accelerations that are not there are central differences of order 6 of the filtered
## coordinates (of the speeds, where these are there), which needs times at equal distances; the
## three rows at both ends without them are left out.
##
## @var{d}: @code{t}, @code{q}, @code{u}, @code{ud}, @code{tau}, @code{other}, @code{other_d},
## @code{cutoff} ([]: no filter), @code{raw} (@code{t}, @code{q}, @code{tau} of all rows, as
## measured).
##
## @c session octave
## @example
## >> m = gsmbp_build ("pinned");
## >> heavy = gsmbp_set (m, "mb", 2.5, "d", 0.3);
## >> p = gsmbp_plan ("quintic", [0 2 -1], [0 1 2.5]);
## >> r = gsmbp_inverse (heavy, p, 0:0.02:2.5);
## >> d = gsmbp_measured (m, struct ("t", r.t, "q", r.q, "tau", r.tau));
## >> [rows(r.t), rows(d.t)]
## ans =
##
##    126   120
## >> max (abs (d.u - r.u(4:end-3))) < 1e-2
## ans = 1
## @end example
##
## Errors: a file that cannot be read; a column that is missing, a head that is there twice, a
## cell that is no number (line and column are said), a unit of another quantity; times that do not
## increase, or not by equal steps where a filter or a derivative needs them; a cutoff of half the
## sampling frequency or more; times so short that no row is left (seconds called milliseconds).
## Source: own; Gautier, Identification of robots dynamics (filters and differences without shift).
## @seealso{gsmbp_identify, gsmbp_csv, gsmbp_names}
## @end deftypefn

function d = gsmbp_measured (m, data, varargin)
  if (nargin < 2)
    print_usage ();
  endif
  who = "gsmbp_measured";
  gs.given.check_model (who, m);
  gs.given.check_open_chain (who, m);
  o = gs.given.call_options (who, {"columns", {}, "names"; "also", {}, "names"
                                   "cutoff", [], "any"; "order", 4, "whole"
                                   "drop", [], "nonnegative"}, varargin);
  if (o.order < 2 || mod (o.order, 2) != 0)
    error ("%s: option order: expected an even number from 2 on, found %d", who, o.order);
  elseif (! (isempty (o.cutoff) || any (strcmp (o.cutoff, {"auto", "spline"}))))
    gs.given.check_kind (who, "option cutoff: \"auto\", \"spline\" or a frequency", o.cutoff, ...
                         "positive");
  endif
  if (ischar (data))
    d = of_file (who, m, data, o);
  else
    d = of_struct (who, m, data);
  endif
  d.t = gs.given.given_times (who, d.t)';
  d.raw = struct ("t", d.t, "q", d.q, "tau", d.tau);
  d = smoothed (who, d, o);
endfunction

function d = of_struct (who, m, data)
  if (! (isstruct (data) && isscalar (data) && all (isfield (data, {"t", "q", "tau"}))))
    error ("%s: argument data: expected a file or a struct with the fields t, q, tau, found %s", ...
           who, gs.text.shown_value (data));
  endif
  d.t = data.t(:);
  for name = {"q", "u", "ud", "tau"}
    d.(name{1}) = [];
    if (isfield (data, name{1}) && ! isempty (data.(name{1})))
      x = data.(name{1});
      gs.identify.check_data (who, m, name{1}, x, numel (d.t));
      d.(name{1}) = double (x);
    endif
  endfor
  [d.other, d.other_d] = deal (struct ());
  if (isfield (data, "other"))
    d.other = data.other;
  endif
endfunction

function d = of_file (who, m, file, o)
  [heads, values, units] = gs.text.csv_columns (who, file);
  names = m.coordinates(:)';
  take = @(list, needed, unit) taken (who, file, heads, values, units, list, o.columns, needed, ...
                                      unit);
  d.t = take ({"t"}, true, {"s"});
  angle = cellfun (@(u) ! strncmp (u, "m", 1), m.units.coordinates(:)');
  d.q = take (names, true, words (angle, "rad", "m"));
  d.u = take (strcat (names, "_d"), false, words (angle, "rad/s", "m/s"));
  d.ud = take (strcat (names, "_dd"), false, words (angle, "rad/s^2", "m/s^2"));
  d.tau = take (strcat ("effort.", names), isempty (o.also), words (angle, "N*m", "N"));
  [d.other, d.other_d] = deal (struct ());
  if (! isempty (o.also))
    for head = cellstr (o.also)(:)'
      d.other.(head{1}) = taken (who, file, heads, values, units, head, {}, true, {""});
    endfor
  endif
endfunction

function list = words (angle, one, other)
  list = cell (size (angle));
  list(angle) = {one};
  list(! angle) = {other};
endfunction

## the columns of a list of names, [] where none is there and none is needed
function x = taken (who, file, heads, values, units, list, columns, needed, wanted)
  x = [];
  for k = 1:numel (list)
    head = list{k};
    renamed = find (strcmp (columns(1:2:end), head));
    if (! isempty (renamed))
      head = columns{2 * renamed(1)};
    endif
    c = find (strcmp (heads, head));
    if (isempty (c) && (needed || ! isempty (x) || ! isempty (renamed)))
      error ("%s: %s: expected a column %s, found %s", who, file, head, strjoin (heads, ", "));
    elseif (isempty (c))
      return;
    endif
    x(:,k) = values(:,c) * factor (who, sprintf ("%s: column %d, %s", file, c, head), ...
                                   units{c}, wanted{min (k, end)});
  endfor
endfunction

function f = factor (who, at, unit, wanted)
  f = 1;
  if (isempty (unit))
    return;
  endif
  [f, powers, unknown] = gs.text.unit_in_si (unit);
  if (! isempty (unknown))
    error ("%s: %s: %s is no unit that is known", who, at, unknown);
  endif
  [~, right] = gs.text.unit_in_si (wanted);
  if (! isempty (wanted) && ! isequal (powers, right))
    error ("%s: %s: expected a unit like %s, found %s", who, at, wanted, unit);
  endif
endfunction

## filtered, with its derivatives, without the ends
function d = smoothed (who, d, o)
  h = mean (diff (d.t));
  smooth = d.other;
  if (strcmp (o.cutoff, "spline"))
    [d, o.cutoff] = deal (by_spline (who, d), []);
  elseif (! isempty (o.cutoff))
    uniform (who, d.t, "option cutoff");
    o.cutoff = cutoff_of (who, d, o, h);
    pass = @(x) gs.identify.zero_phase (x, h, o.cutoff, o.order);
    for name = {"q", "u", "ud"}
      if (! isempty (d.(name{1})))
        d.(name{1}) = pass (d.(name{1}));
      endif
    endfor
    smooth = structfun (pass, d.other, "UniformOutput", false);
    if (isempty (o.drop))
      o.drop = 1 / o.cutoff;
    endif
  endif
  d = with_derivatives (who, d, h, smooth);
  keep = ! any (isnan ([d.q, d.u, d.ud]), 2);
  if (! isempty (o.drop))
    keep &= d.t >= d.t(1) + o.drop & d.t <= d.t(end) - o.drop;
  endif
  keep = find (keep);
  if (isempty (keep))
    error (["%s: no row is left of %d: the times last %.3g s, steps of %.3g s; the filter and " ...
            "the differences leave out %.3g s at both ends%s"], who, numel (d.t), ...
           d.t(end) - d.t(1), h, max ([o.drop, 3 * h]), doubt_of (h));
  endif
  d = kept (d, keep);
  d.cutoff = o.cutoff;
endfunction

function d = by_spline (who, d)
  s = gs.identify.smooth_spline (d.t, d.q);
  if (isempty (s))
    error ("%s: %d times are too few for a smooth motion through them", who, numel (d.t));
  endif
  d = gs.identify.spline_derivatives (d, s.B, s.c);
endfunction

## times that are seconds and called milliseconds, or the other way
function text = doubt_of (h)
  text = "";
  if (h < 5e-5)
    text = "; do the times have the unit that their head says (t [ms] for times in s)?";
  elseif (h > 0.2)
    text = "; are the times in milliseconds? Then their head is t [ms]";
  endif
endfunction

function f = cutoff_of (who, d, o, h)
  f = o.cutoff;
  if (strcmp (f, "auto"))
    f = gs.identify.best_cutoff (d.t, d.q, o.order);
    if (isempty (f))
      error ("%s: option cutoff: %d times are too few to propose one", who, numel (d.t));
    endif
  elseif (f >= 0.5 / h)
    error (["%s: option cutoff: expected less than half the sampling frequency, %g Hz, found " ...
            "%g%s"], who, 0.5 / h, f, doubt_of (h));
  endif
endfunction

function d = with_derivatives (who, d, h, smooth)
  if (isempty (d.u))
    uniform (who, d.t, "speeds by differences");
    [d.u, dd] = gs.identify.time_differences (d.q, h);
    if (isempty (d.ud))
      d.ud = dd;
    endif
  elseif (isempty (d.ud))
    uniform (who, d.t, "accelerations by differences");
    d.ud = gs.identify.time_differences (d.u, h);
  endif
  if (numfields (d.other) > 0)
    uniform (who, d.t, "derivatives of other columns");
    d.other_d = structfun (@(x) gs.identify.time_differences (x, h), smooth, "UniformOutput", ...
                           false);
  endif
endfunction

function d = kept (d, keep)
  for name = {"t", "q", "u", "ud", "tau"}
    if (! isempty (d.(name{1})))
      d.(name{1}) = d.(name{1})(keep,:);
    endif
  endfor
  d.other = structfun (@(x) x(keep), d.other, "UniformOutput", false);
  d.other_d = structfun (@(x) x(keep), d.other_d, "UniformOutput", false);
endfunction

function uniform (who, t, what)
  step = diff (t);
  [worst, k] = max (abs (step - mean (step)));
  if (worst > 1e-4 * mean (step))
    error (["%s: %s needs times at equal distances; from t = %.9g the step is %.9g s, the mean " ...
            "is %.9g s; take the option cutoff \"spline\""], who, what, t(k), step(k), mean (step));
  endif
endfunction

%!shared m
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%!function d = read (m, text, varargin)
%! file = [tempname() ".csv"];
%! f = fopen (file, "w");
%! fputs (f, text);
%! fclose (f);
%! guard = onCleanup (@() delete (file));
%! d = gsmbp_measured (m, file, varargin{:});
%!endfunction
%!test <differences and the filter do not shift>
%! t = (0:0.002:4)';
%! d = gsmbp_measured (m, struct ("t", t, "q", sin (5*t), "tau", cos (3*t)));
%! assert (d.u, 5 * cos (5 * d.t), 1e-10);
%! assert (d.ud, -25 * sin (5 * d.t), 1e-8);
%! d = gsmbp_measured (m, struct ("t", t, "q", sin (5*t), "tau", cos (3*t)), "cutoff", 20);
%! assert (d.t([1 end]), [0.05; 3.95], 1e-9);
%! g = 1 / (1 + (tan (pi * 0.002 * 5/(2*pi)) / tan (pi * 0.002 * 20)) ^ 8);
%! assert (d.q, g * sin (5 * d.t), 2e-4);
%! inner = d.t > 1 & d.t < 3;
%! assert (d.q(inner), g * sin (5 * d.t(inner)), 1e-11);
%!test <noise above the cutoff goes>
%! t = (0:0.001:2)';
%! d = gsmbp_measured (m, struct ("t", t, "q", sin (5*t) + 0.01*sin (2*pi*200*t), "tau", t), ...
%!                     "cutoff", 20, "drop", 0.3);
%! assert (d.ud, -25 * sin (5 * d.t), 1e-3);
%! assert (d.tau, d.t);
%!test <a file: units, names of one's own, other columns>
%! d = read (m, "M1 [Nmm],t [ms],i,p [deg],w\n1000,0,7,180,1\n3000,500,8,90,2\n", ...
%!           "columns", {"q", "p", "effort.q", "M1", "q_d", "w", "q_dd", "w"});
%! assert ({d.t, d.q, d.u, d.ud, d.tau}, {[0; 0.5], [pi; pi/2], [1; 2], [1; 2], [1; 3]});
%!test
%! d = read (m, sprintf ("t,q,i\n%s", sprintf ("%g,%g,%g\n", [0:9; (0:9)/2; 2*(0:9)])), ...
%!           "also", "i");
%! assert ({d.other.i, d.tau}, {2*(3:6)', []});
%! assert (d.other_d.i, 2 * ones (4, 1), 1e-12);
%!error <expected a column effort.q, found t, q> read (m, "t,q\n0,1\n1,2\n")
%!error <line 3, column 2: expected a number, found x> read (m, "t,q\n0,1\n1,x\n")
%!error <line 2: expected 2 cells, found 3> read (m, "t,q\n0,1,2\n")
%!error <line 1: expected commas between the columns .*found semicolons> read (m, "t;q\n0,5;1\n")
%!error <line 2: expected commas.*found tabs> read (m, "# of a logger\nt\tq\n0\t1\n")
%!error <the head q is there twice> read (m, "t,q,q\n0,1,2\n")
%!error <column 2, q: expected a unit like rad, found kg>
%! read (m, "t,q [kg],effort.q\n0,1,2\n1,1,2\n")
%!error <needs times at equal distances; from t = 1 the step is 3 s>
%! gsmbp_measured (m, struct ("t", [0 1 4 5], "q", (1:4)', "tau", (1:4)'))
%!error <expected less than half the sampling frequency, 0.5 Hz, found 2>
%! gsmbp_measured (m, struct ("t", 0:3, "q", (1:4)', "tau", (1:4)'), "cutoff", 2)
%!error <no row is left of 4>
%! gsmbp_measured (m, struct ("t", 0:3, "q", (1:4)', "tau", (1:4)'))
%!error <data.tau: expected 4 x 1 finite numbers, found 3>
%! gsmbp_measured (m, struct ("t", 0:3, "q", (1:4)', "tau", 3))
%!error <cannot read no_such.csv> gsmbp_measured (m, "no_such.csv")
