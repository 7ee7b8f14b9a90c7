## -*- texinfo -*-
## @c category Figures, tables, pages
## @deftypefn  {} {} gsmbp_plot (@var{file}, @var{m}, @var{result}, @var{names})
## @deftypefnx {} {} gsmbp_plot (@var{file}, @var{m}, @var{result})
## @deftypefnx {} {} gsmbp_plot (@var{file}, @var{t}, @var{panel}, @dots{})
## @deftypefnx {} {} gsmbp_plot (@dots{}, @var{option}, @var{value}, @dots{})
## Draw a figure without a screen: @var{file} is a PNG, PDF, SVG or EPS by its ending, and the same
## numbers go into the .csv beside it.
##
## In the first form the named quantities of a @var{result} of @code{gsmbp_simulate} or
## @code{gsmbp_inverse} are drawn (@code{gsmbp_names} tells the names), a panel for each unit, with
## the quantity and its unit on the axis, the unit with a prefix where the numbers are large or
## small.  The column heads of the .csv hold the units, its numbers are in SI.  Without @var{names}
## these are all states and inputs.
##
## In the third form the panels lie one above the other over the common abscissa @var{t}.  Each
## @var{panel} is a struct with
## @table @code
## @item y
## a row for each entry of @var{t}, a column for each curve
## @item names
## cell array: what each curve is (legend, and column head of the .csv)
## @item label
## the quantity and its unit, for the axis, e.g. "torque [N m]"; a unit in plain letters ("[um]",
## "[m^2]", "[degrees]", "[ohm]") is shown with the signs of the field
## @item style
## (optional) "lines" (default), "linespoints", "points", "steps" (a value holds to the next row) or
## "fsteps" (it holds from the row before on: so are modes drawn, and what sampled devices hold); a
## cell array has one for each curve
## @item heading
## (optional) what sets this panel apart, above it, e.g. "start 5 mm aside"
## @item factor
## (optional) what the numbers are multiplied by in the figure, e.g. 1e-3 for kN
## @end table
## Curves differ in colour, dashes and width; the legend stands above its panel.  A panel of one
## curve whose label holds its name has none.
##
## Options: "xlabel" (default "time [s]"), "title", "scale": "linear"
## (default), "semilogy", "semilogx" or "loglog"; "head": column head of
## @var{t} in the .csv (default "t", in the first form "t [s]"); "size": width and height [cm]
## (default 16 by what the panels need); "dpi" of a PNG (default 160); "fontsize" [pt] (default 10).
##
## @c session octave
## @example
## >> t = linspace (0, 2, 100)';
## >> y = struct ("y", [sin(3*t), cos(3*t)], "names", @{@{"sine", "cosine"@}@}, "label", "y [m]");
## >> gsmbp_plot ("waves.png", t, y, "title", "Two waves");
## >> m = gsmbp_build ("slider_crank");
## >> r = gsmbp_simulate (m, m.initial, 0:0.01:0.5, "input", 12);
## >> gsmbp_plot ("crank.pdf", m, r, @{"q1", "q2", "q3"@}, "size", [8 6]);
## @end example
##
## Errors: a file that ends otherwise or cannot be written; a name that the result has not; a panel
## without y, names and label of fitting sizes; an unknown scale or option.
## Source: own; the drawing is gnuplot's.
## @seealso{gsmbp_names, gsmbp_csv, gsmbp_simulate, gsmbp_workprecision}
## @end deftypefn

function gsmbp_plot (file, t, varargin)
  if (nargin < 3 || ! ischar (file))
    print_usage ();
  endif
  who = "gsmbp_plot";
  [~, ~, kind] = fileparts (file);
  if (! any (strcmpi (kind, {".png", ".pdf", ".svg", ".eps"})))
    error ("%s: the file must end in .png, .pdf, .svg or .eps, found: %s", who, file);
  endif
  [t, panels, rest, head] = what_to_draw (who, t, varargin);
  table = {"title", "", "text"
           "xlabel", "time [s]", "text"
           "scale", "linear", {"linear", "semilogy", "semilogx", "loglog"}
           "head", head, "text"
           "size", [], "numbers"; "dpi", 160, "positive"; "fontsize", 10, "positive"};
  o = gs.given.call_options (who, table, rest);
  if (! (isnumeric (t) && isreal (t)))
    error ("%s: argument t: expected real numbers, found %s", who, gs.text.shown_value (t));
  endif
  t = t(:);
  check (who, t, panels);
  o.limits = [min(t), max(t)];
  data = t;
  heads = {o.head};
  for i = 1:numel (panels)
    data = [data, panels{i}.y];
    heads = [heads, heads_of(panels{i})];
  endfor
  table = gs.files.new_beside (who, [file(1:end-numel (kind)) ".csv"]);
  guard = onCleanup (@() gs.files.discard_file (table));
  gsmbp_csv (table, heads, data);
  size = size_of (who, o, numel (panels));
  gs.files.run_gnuplot (who, file, gs.files.gnuplot_terminal (tolower (kind), size, o), ...
                        gs.draw.plot_lines (table, panels, o, size), table);
endfunction

## abscissa, panels, the options behind them, column head of the abscissa
function [t, panels, rest, head] = what_to_draw (who, t, args)
  head = "t";
  if (isstruct (t))
    gs.given.check_model (who, t);
    head = "t [s]";
    m = t;
    result = args{1};
    args(1) = [];
    names = [m.states; m.inputs];
    if (! isempty (args) && (iscellstr (args{1}) || mod (numel (args), 2) == 1))
      names = args{1};
      args(1) = [];
    endif
    if (! (isstruct (result) && all (isfield (result, {"t", "x", "v"}))))
      error ("%s: argument result: expected a struct with the fields t, x, v, found %s", who, ...
             gs.text.shown_value (result));
    endif
    if (! isfield (result, "of"))
      result = gs.model.named_results (m, result);
    endif
    [t, panels, rest] = deal (result.t, gs.model.named_panels (who, m, result, names), args);
    return;
  endif
  first = find (cellfun (@ischar, args), 1);
  if (isempty (first))
    first = numel (args) + 1;
  endif
  [panels, rest] = deal (args(1:first-1), args(first:end));
endfunction

function heads = heads_of (p)
  heads = p.names(:)';
  if (isfield (p, "heads"))
    heads = p.heads;
  endif
endfunction

function size = size_of (who, o, n)
  size = [16, 1.9 + 4.6 * n + 0.6 * (! isempty (o.title))];
  if (! isempty (o.size))
    if (numel (o.size) != 2 || any (o.size < 2) || any (o.size > 200))
      error ("%s: option size: expected width and height from 2 to 200 cm, found %s", who, ...
             gs.text.shown_value (o.size));
    endif
    size = double (o.size(:)');
  endif
endfunction

function check (who, t, panels)
  if (isempty (panels))
    error ("%s: nothing to draw", who);
  endif
  for i = 1:numel (panels)
    p = panels{i};
    if (! (isstruct (p) && isscalar (p) && all (isfield (p, {"y", "names", "label"}))))
      error ("%s: panel %d must be a struct with the fields y, names, label, found %s", who, ...
             i, gs.text.shown_value (p));
    endif
    if (! (iscellstr (p.names) && ischar (p.label) && isnumeric (p.y) && isreal (p.y)))
      error (["%s: panel %d: expected numbers y, a list of names and a text label, found " ...
              "%s, %s and %s"], who, i, gs.text.shown_value (p.y), ...
                  gs.text.shown_value (p.names), gs.text.shown_value (p.label));
    endif
    if (isfield (p, "heading"))
      gs.given.check_kind (who, sprintf ("panel %d: heading", i), p.heading, "text");
    endif
    if (isfield (p, "style"))
      check_style (who, sprintf ("panel %d: style", i), p);
    endif
    if (rows (p.y) != numel (t))
      error ("%s: panel %d: expected %d rows, found %d", who, i, numel (t), rows (p.y));
    endif
    if (columns (p.y) != numel (p.names))
      error ("%s: panel %d: %d names for %d curves", who, i, numel (p.names), columns (p.y));
    endif
  endfor
endfunction

function check_style (who, what, p)
  styles = p.style;
  if (! iscell (styles))
    styles = repmat ({styles}, size (p.names));
  elseif (numel (styles) != numel (p.names))
    error ("%s: %s: expected one for each of the %d curves, found %d", who, what, ...
           numel (p.names), numel (styles));
  endif
  for style = styles(:)'
    gs.given.check_kind (who, what, style{1}, {"lines", "linespoints", "points", "steps", ...
                                               "fsteps"});
  endfor
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
%!   addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%!   m = gsmbp_hand ("motor_pendulum");
%!   r = gsmbp_simulate (m, [0.2 0 0], 0:0.1:1, "input", 3);
%!   for kind = {"png", "pdf", "svg", "eps"}
%!     file = fullfile (folder, ["b." kind{1}]);
%!     gsmbp_plot (file, m, r, {"q", "drive.i", "offset"}, "size", [8 7], "dpi", 100);
%!     assert (stat (file).size > 3000);
%!   endfor
%!   f = fopen (fullfile (folder, "b.png"));
%!   header = fread (f, 24, "uint8")';
%!   fclose (f);
%!   assert (header([19 20 23 24]), [floor(315/256), mod(315, 256), floor(276/256), mod(276, 256)]);
%!   assert (strtok (fileread (fullfile (folder, "b.csv")), "\n"), ...
%!           "t [s],q [rad],drive.i [A],offset [m]");
%! unwind_protect_cleanup
%!   confirm_recursive_rmdir (false, "local");
%!   rmdir (folder, "s");
%! end_unwind_protect
%!test <a curve in steps beside one in lines>
%! if (isempty (file_in_path (getenv ("PATH"), "gnuplot")))
%!   return;
%! endif
%! file = [tempname() ".svg"];
%! tidy = onCleanup (@() cellfun (@delete, {file, [file(1:end-3) "csv"]}));
%! p = struct ("y", [0 0; 1 1; 3 3; 2 2], "names", {{"a", "b"}}, "label", "y", ...
%!             "style", {{"lines", "fsteps"}});
%! gsmbp_plot (file, 0:3, p);
%! paths = regexp (fileread (file), "d='([^']*)'", "tokens");
%! corners = cellfun (@(d) numel (regexp (d{1}, "[ML]")), paths);
%! # 2 in the legend, which is a path of its own in gnuplot 6
%! assert (any (corners == 2 + 4) && any (corners == 2 + 7 | corners == 7));
%! p.style = {"lines"};
%! fail ("gsmbp_plot (file, 0:3, p)", "panel 1: style: expected one for each of the 2 curves");
%! p.style = {"lines", "stairs"};
%! fail ("gsmbp_plot (file, 0:3, p)", "panel 1: style: expected one of .*, found \"stairs\"");
%!test <units as the field writes them, with the prefix of small numbers>
%! if (isempty (file_in_path (getenv ("PATH"), "gnuplot")))
%!   return;
%! endif
%! file = [tempname() ".svg"];
%! micro = "\302\265";
%! written = {"Pa", [micro "Pa"]; "W", [micro "W"]; "m/s", [micro "m/s"]; "N*m", [micro "N m"]
%!            "ohm", [micro "\316\251"]; "m^2", [micro "m\302\262"]; "Wb", [micro "Wb"]};
%! unwind_protect
%!   for row = written'
%!     gsmbp_plot (file, [0 1], struct ("y", [0; 2], "names", {{"a"}}, "label", ...
%!                                      ["y [u" row{1} "]"]));
%!     assert (any (strfind (fileread (file), ["[" row{2} "]"])));
%!   endfor
%! unwind_protect_cleanup
%!   delete (file);
%!   delete ([file(1:end-3) "csv"]);
%! end_unwind_protect
%!test <wide letters of a legend have their room>
%! if (isempty (file_in_path (getenv ("PATH"), "gnuplot")))
%!   return;
%! endif
%! file = [tempname() ".svg"];
%! tidy = onCleanup (@() cellfun (@delete, {file, [file(1:end-3) "csv"]}));
%! apart = [];
%! for names = {{"MWM8", "MWM9"}, {"abc8", "abc9"}}
%!   gsmbp_plot (file, [0 1], struct ("y", eye (2), "names", names, "label", "y"));
%!   at = regexp (fileread (file), 'translate\(([\d.]+),[^>]*>\s*<text>\w{3}[89]<', "tokens");
%!   apart(end+1) = diff (str2double ([at{:}]));
%! endfor
%! assert (apart(1) > apart(2) + 10);   # pixels
%!error <must end in .png, .pdf, .svg or .eps> gsmbp_plot ("a.gif", 1, struct ())
%!error <panel 1: expected 2 rows, found 1>
%! gsmbp_plot ("a.png", [1 2], struct ("y", 1, "names", {{"a"}}, "label", "b"))
