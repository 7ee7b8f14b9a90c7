## -*- texinfo -*-
## @c category Figures, tables, pages
## @deftypefn  {} {} gsmbp_plot (@var{file}, @var{t}, @var{panel}, @dots{})
## @deftypefnx {} {} gsmbp_plot (@var{file}, @var{m}, @var{result})
## @deftypefnx {} {} gsmbp_plot (@dots{}, "title", @var{text}, "xlabel", @var{text})
## @deftypefnx {} {} gsmbp_plot (@dots{}, "scale", @var{kind})
## Draw a figure without a screen: @var{file} is a PNG, and the same numbers go
## into the .csv beside it.
##
## The panels lie one above the other over the common abscissa @var{t}.  Each
## @var{panel} is a struct with
## @table @code
## @item y
## a row for each entry of @var{t}, a column for each curve
## @item names
## cell array: what each curve is (legend, and column head of the .csv)
## @item label
## the quantity and its unit, for the axis, e.g. "torque [N m]"
## @item style
## (optional) "lines" (default), "linespoints", "points" or "steps"
## @end table
## In the second form the states and inputs of a @var{result} of
## @code{gsmbp_simulate} (or @code{gsmbp_inverse}) are drawn, a panel for each
## unit.
##
## Options: "xlabel" (default "time [s]"), "title", "scale": "linear"
## (default), "semilogy", "semilogx" or "loglog"; "head": column head of
## @var{t} in the .csv, default "t".
##
## @c session octave
## @example
## >> t = linspace (0, 2, 100)';
## >> y = struct ("y", [sin(3*t), cos(3*t)], "names", @{@{"sine", "cosine"@}@}, "label", "y [m]");
## >> gsmbp_plot ("waves.png", t, y, "title", "Two waves");
## @end example
##
## Errors: a file that does not end in .png or cannot be written; a panel
## without y, names and label of fitting sizes; an unknown scale or option.
## Source: own; the drawing is gnuplot's.
## @seealso{gsmbp_csv, gsmbp_simulate, gsmbp_workprecision}
## @end deftypefn

function gsmbp_plot (file, t, varargin)
  if (nargin < 3 || ! ischar (file))
    print_usage ();
  endif
  who = "gsmbp_plot";
  if (numel (file) < 5 || ! strcmpi (file(end-3:end), ".png"))
    error ("%s: the file must end in .png, found: %s", who, file);
  endif
  first = find (cellfun (@ischar, varargin), 1);
  if (isempty (first))
    first = numel (varargin) + 1;
  endif
  table = {"title", "", "text"
           "xlabel", "time [s]", "text"
           "scale", "linear", {"linear", "semilogy", "semilogx", "loglog"}
           "head", "t", "text"};
  o = gsmbp__options (who, table, varargin(first:end));
  panels = varargin(1:first-1);
  if (isstruct (t))
    gsmbp__model (who, t);
    if (! (isstruct (panels{1}) && all (isfield (panels{1}, {"t", "x", "v"}))))
      error ("%s: argument result: expected a struct with the fields t, x, v, found %s", who, ...
             gsmbp__shown (panels{1}));
    endif
    [t, panels] = by_unit (t, panels{1});
  endif
  if (! (isnumeric (t) && isreal (t)))
    error ("%s: argument t: expected real numbers, found %s", who, gsmbp__shown (t));
  endif
  t = t(:);
  check (who, t, panels);

  data = t;
  heads = {o.head};
  for i = 1:numel (panels)
    data = [data, panels{i}.y];
    heads = [heads, panels{i}.names(:)'];
  endfor
  table = sprintf ("%s-%d.csv", file(1:end-4), getpid ());
  guard = onCleanup (@() gsmbp__discard (table));
  gsmbp_csv (table, heads, data);
  draw (file, table, panels, o);
endfunction

## one panel for each unit, in the order in which the units appear
function [t, panels] = by_unit (m, result)
  t = result.t;
  names = [m.states; m.inputs];
  units = [m.units.states; m.units.inputs];
  y = [result.x, result.v];
  panels = {};
  for unit = unique (units, "stable")'
    k = find (strcmp (units, unit{1}));
    panels{end+1} = struct ("y", y(:,k), "names", {names(k)'}, "label", sprintf ("[%s]", unit{1}));
  endfor
endfunction

function check (who, t, panels)
  if (isempty (panels))
    error ("%s: nothing to draw", who);
  endif
  for i = 1:numel (panels)
    p = panels{i};
    if (! (isstruct (p) && isscalar (p) && all (isfield (p, {"y", "names", "label"}))))
      error ("%s: panel %d must be a struct with the fields y, names, label", who, i);
    endif
    if (! (iscellstr (p.names) && ischar (p.label) && isnumeric (p.y) && isreal (p.y)))
      error (["%s: panel %d: expected numbers y, a list of names and a text label, found " ...
              "%s, %s and %s"], who, i, gsmbp__shown (p.y), gsmbp__shown (p.names), ...
             gsmbp__shown (p.label));
    endif
    if (isfield (p, "style"))
      gsmbp__fits (who, sprintf ("panel %d: style", i), p.style, ...
                   {"lines", "linespoints", "points", "steps"});
    endif
    if (rows (p.y) != numel (t))
      error ("%s: panel %d: expected %d rows, found %d", who, i, numel (t), rows (p.y));
    endif
    if (columns (p.y) != numel (p.names))
      error ("%s: panel %d: %d names for %d curves", who, i, numel (p.names), columns (p.y));
    endif
  endfor
endfunction

## gnuplot draws from the .csv itself, so figure and numbers are the same
function draw (file, table, panels, o)
  n = numel (panels);
  tight = "";
  if (any (strcmp (o.scale, {"linear", "semilogy"})))
    tight = "set autoscale xfix";
  endif
  terminal = sprintf ("pngcairo noenhanced size 1000,%d font 'FreeSans,12'", 90 + 270 * n);
  lines = ...
      {"set datafile separator comma", "set datafile missing 'NaN'", ...
       "set grid lc rgb '#bbbbbb'", tight, ...
           "set lmargin at screen 0.1", "set rmargin at screen 0.80", axes_of(o.scale)};
  top = 1 - 45 / (90 + 270 * n);
  bottom = 60 / (90 + 270 * n);
  lines{end+1} = "set multiplot";
  if (! isempty (o.title))
    lines{end+1} = sprintf ("set label 1 %s at screen 0.45,%.4f center font ',14'", ...
                            gsmbp__quoted (o.title), 1 - 22 / (90 + 270 * n));
  endif
  column = 2;
  for i = 1:n
    p = panels{i};
    style = "lines";
    if (isfield (p, "style"))
      style = p.style;
    endif
    height = (top - bottom) / n;
    lines{end+1} = sprintf ("set tmargin at screen %.4f", top - (i - 1) * height);
    lines{end+1} = sprintf ("set bmargin at screen %.4f", ...
                            top - i * height + 0.16 * height * (i < n));
    lines{end+1} = sprintf (["set key at screen 0.81,%.4f left top vertical Left reverse " ...
                             "samplen 2"], ...
                            top - (i - 1) * height);
    lines{end+1} = sprintf ("set ylabel %s", gsmbp__quoted (p.label));
    if (i == n)
      lines{end+1} = sprintf ("set xlabel %s", gsmbp__quoted (o.xlabel));
    endif
    curves = {};
    colors = gsmbp__colors (columns (p.y));
    for k = 1:columns (p.y)
      curves{k} = sprintf ("%s using 1:%d skip 1 with %s lw 2 pt 7 ps 1 lc rgb '%s' title %s", ...
                           gsmbp__quoted (table), column, style, colors{k}, ...
                           gsmbp__quoted (p.names{k}));
      column++;
    endfor
    lines{end+1} = ["plot " strjoin(curves, ", ")];
    lines{end+1} = "unset label 1";
  endfor
  lines{end+1} = "unset multiplot";
  gsmbp__gnuplot ("gsmbp_plot", file, terminal, lines, table);
endfunction

function text = axes_of (scale)
  text = struct ("linear", "", "semilogy", "set logscale y; set format y '%.0e'", "semilogx", ...
                 "set logscale x", "loglog", "set logscale xy; set format y '%.0e'");
  if (! isfield (text, scale))
    error ("gsmbp_plot: scale must be linear, semilogy, semilogx or loglog, found: \"%s\"", scale);
  endif
  text = text.(scale);
endfunction

%!test
%! if (isempty (file_in_path (getenv ("PATH"), "gnuplot")))
%!   return;
%! endif
%! folder = tempname ();
%! mkdir (folder);
%! t = (0:0.1:1)';
%! unwind_protect
%!   gsmbp_plot (fullfile (folder, "a.png"), t, ...
%!               struct ("y", [sin(t), cos(t)], "names", {{"a_1", "b"}}, "label", ...
%!                       "angle [rad]"));
%!   assert (fileread (fullfile (folder, "a.csv"))(1:13), "t,a_1,b\n0,0,1");
%!   assert (stat (fullfile (folder, "a.png")).size > 3000);
%! unwind_protect_cleanup
%!   confirm_recursive_rmdir (false, "local");
%!   rmdir (folder, "s");
%! end_unwind_protect
%!error <must end in .png> gsmbp_plot ("a.pdf", 1, struct ())
%!error <panel 1: expected 2 rows, found 1>
%! gsmbp_plot ("a.png", [1 2], struct ("y", 1, "names", {{"a"}}, "label", "b"))
