## -*- texinfo -*-
## @c category Figures
## @deftypefn  {} {} gsmbp_sweep_plot (@var{file}, @var{w}, "scatter", @var{name})
## @deftypefnx {} {} gsmbp_sweep_plot (@var{file}, @var{w}, "tornado", @var{name})
## @deftypefnx {} {} gsmbp_sweep_plot (@var{file}, @var{w}, "indices", @var{name})
## Draw a sweep: @var{w} of @code{gsmbp_sweep}; @var{file} ends in .png, .pdf, .svg or .eps, the
## numbers come into the .csv beside it, a row for each run or, under "parameter", for the name of
## each parameter.  @var{name} is one of what was kept (default the first).
##
## @code{"scatter"}: it over each parameter, a point for each run that came to its end (5000 at
## most), with the correlation of ranks ("constant": what is kept, or the parameter, does not vary).
##
## @code{"tornado"}: a bar for each parameter, the longest on top: from where to where a linear fit
## to all runs says that it goes while the parameter goes from its quantile 0.05 to that of 0.95,
## the others at their means; below it says what share of the variance the fit explains.
##
## @code{"indices"}: the indices of Sobol of a sweep by the plan "indices", alone and with the
## others.
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> vary = struct ("la", [4e-3 6e-3], "km", @{@{"normal", 0.228, 0.005@}@});
## >> kept = @{["final " m.states@{4@}]@};
## >> o = @{"input", 12, "vary", vary, "runs", 64, "keep", kept@};
## >> w = gsmbp_sweep (m, m.initial, [0 0.1 0.2], o@{:@});
## >> gsmbp_sweep_plot ("scatter.png", w, "scatter");
## >> gsmbp_sweep_plot ("tornado.png", w, "tornado");
## @end example
##
## Errors: no result of gsmbp_sweep; a name that it has not; no run that came to its end; fewer runs
## than a fit needs; indices of another plan, or of what is constant.
## Source: own; the drawing is gnuplot's.
## @seealso{gsmbp_sweep, gsmbp_plot}
## @end deftypefn

function gsmbp_sweep_plot (file, w, kind = "scatter", name = "")
  if (nargin < 2 || ! ischar (file))
    print_usage ();
  endif
  who = "gsmbp_sweep_plot";
  if (! (isstruct (w) && isscalar (w) && all (isfield (w, {"names", "values", "correlation"}))))
    error ("%s: argument w: expected a result of gsmbp_sweep, found %s", who, ...
           gs.text.shown_value (w));
  endif
  gs.given.check_kind (who, "argument kind", kind, {"scatter", "tornado", "indices"});
  [~, ~, ending] = fileparts (file);
  if (! any (strcmpi (ending, {".png", ".pdf", ".svg", ".eps"})))
    error ("%s: the file must end in .png, .pdf, .svg or .eps, found: %s", who, file);
  endif
  s = chosen (who, w, name);
  rows_of = {};   # names of parameters
  switch (kind)
    case "scatter"
      [lines, heads, data, size] = scatter (w, s);
    case "tornado"
      [lines, heads, data, size, rows_of] = tornado (who, s);
    case "indices"
      [lines, heads, data, size, rows_of] = indices (who, w, s);
  endswitch
  table = gs.files.new_beside (who, [file(1:end-numel (ending)) ".csv"]);
  guard = onCleanup (@() gs.files.discard_file (table));
  write_table (table, heads, rows_of, data);
  look = struct ("dpi", 160, "fontsize", 10);
  gs.files.run_gnuplot (who, file, gs.files.gnuplot_terminal (tolower (ending), size, look), ...
                        lines, table);
endfunction

## the numbers of a figure, each row behind a name where there are such
function write_table (file, heads, names, data)
  if (isempty (names))
    gsmbp_csv (file, heads, data);
    return;
  endif
  row = @(k) [names{k}, sprintf(",%.17g", data(k,:)), "\n"];
  gs.files.write_text ("gsmbp_sweep_plot", file, ...
                       [strjoin(heads, ","), "\n", arrayfun(row, 1:rows (data), ...
                                                            "UniformOutput", false){:}]);
endfunction

## the runs that came to their end and have a number there: parameters P, the quantity Z, names and
## labels
function s = chosen (who, w, name)
  k = rows (w.correlation);
  s.at = k + 1;
  if (! isempty (name))
    s.at = k + find (strcmp (w.names(k+1:end), name), 1);
    if (isempty (s.at))
      error ("%s: argument name: unknown %s", who, gs.text.nearest_word (name, w.names(k+1:end)));
    endif
  endif
  if (s.at > columns (w.values))
    error ("%s: nothing was kept of the runs but whole ones, which gsmbp_plot draws", who);
  endif
  here = w.ok & ! isnan (w.values(:,s.at));
  if (! any (here))
    error ("%s: expected a run that came to its end and has %s, found none in %d runs", who, ...
           w.names{s.at}, numel (here));
  endif
  s.p = w.values(here,1:k);
  s.z = w.values(here,s.at);
  s.names = w.names(1:k);
  s.name = w.names{s.at};
  s.labels = cellfun (@label, w.names, w.units, "UniformOutput", false);
endfunction

function text = label (name, unit)
  text = gs.text.plot_label ([name, [" [" unit "]"](1:end*! isempty (unit))]);
endfunction

function lines = begun (n, wide)
  lines = {"set encoding utf8", "unset key", "set border 3 lc rgb '#4d4d4d'", ...
           "set tics nomirror out", sprintf("set multiplot layout %d,%d", ceil (n / wide), wide)};
endfunction

function text = quoted (text)
  text = [gs.text.gnuplot_quoted(text) " noenhanced"];
endfunction

function [lines, heads, data, size] = scatter (w, s)
  k = numel (s.names);
  wide = min (k, 3);
  size = [1.5 + 5.5 * wide, 6 * ceil(k / wide)];
  some = unique (round (linspace (1, rows (s.p), min (rows (s.p), 5000))));
  lines = [begun(k, wide), {"set autoscale xfix; set autoscale yfix", ...
                            ["set offsets " strjoin(repmat ({"graph 0.04"}, 1, 4), ", ")]}];
  [tics, letters] = tics_of (s.z, Inf);
  lines = [lines, {["set ytics (" tics ")"], sprintf("set lmargin %.3g", 4.5 + letters)}];
  dot = min (0.9, max (0.3, 0.3 * (2000 / numel (some)) ^ (1/3)));
  first = mod (0:k-1, wide) == 0;   # in its row
  for j = 1:k
    lines = [lines, {sprintf("set title %s", ...
                             quoted (ranks (w.correlation(j,s.at-k), s.p(:,j), s.z))), ...
                     ["set xtics (" tics_of(s.p(:,j), 5 - 2 * (letters > 5)) ")"], ...
                     sprintf("set xlabel %s", quoted (s.labels{j})), ...
                     sprintf("set ylabel %s", quoted ({"", s.labels{s.at}}{1 + first(j)})), ...
                     "$d << END", sprintf("%.9g %.9g\n", [s.p(some,j), s.z(some)]'), "END", ...
                     sprintf("plot $d with points pt 7 ps %.2g lc rgb '#00459a'", dot)}];
  endfor
  heads = [s.names, {s.name}];
  data = [s.p(some,:), s.z(some)];
endfunction

## the correlation of ranks, or why there is none
function text = ranks (r, p, z)
  if (! isnan (r))
    text = sprintf ("ranks: %+.2f", r);
  elseif (range (z) == 0 || range (p) == 0)
    text = "constant";
  else
    text = "too few runs for ranks";
  endif
endfunction

## at most four marks of an axis, but two where they are longer than MOST letters; the letters of
## the longest
function [tics, letters] = tics_of (x, most)
  range = max (x) - min (x);
  if (! (range > 1e-9 * max (abs (x))))   # it does not vary
    [text, letters] = told (x(1), x(1));
    tics = [gs.text.gnuplot_quoted(text), sprintf(" %.9g", x(1))];
    return;
  endif
  ten = 10 ^ floor (log10 (range / 4.1));
  step = ten * [1, 2, 2.5, 5, 10](find (range / 4.1 <= ten * [1, 2, 2.5, 5, 10], 1));
  at = step * (ceil (min (x) / step):floor (max (x) / step));
  [texts, letters] = arrayfun (@(x) told (x, max (abs (at))), at, "UniformOutput", false);
  letters = max ([letters{:}]);
  if (numel (at) > 2 && letters > most)   # more have no room
    [at, texts] = deal (at([1, end]), texts([1, end]));
  endif
  tics = strjoin (cellfun (@(text, x) sprintf ("%s %.9g", gs.text.gnuplot_quoted (text), x), ...
                           texts, num2cell (at), "UniformOutput", false), ", ");
endfunction

## a number of an axis whose largest is MOST, as times a power of ten where that is small or large;
## how many letters wide it is
function [text, letters] = told (x, most)
  text = sprintf ("%.9g", x);
  letters = numel (text);
  most = abs (most);
  if (x != 0 && (most < 1e-2 || most >= 1e5))
    power = floor (log10 (most) + 1e-9);
    text = sprintf ("%.6g", x / 10 ^ power);
    letters = numel (text) + 3 + 0.6 * numel (sprintf ("%d", power));
    text = sprintf ("%s\302\26710^{%d}", text, power);
  endif
endfunction

function [lines, heads, data, size, names] = tornado (who, s)
  [n, k] = deal (rows (s.p), numel (s.names));
  centred = s.p - mean (s.p, 1);
  if (n < k + 2 || rank (centred ./ max (std (s.p, 0, 1), realmin)) < k)
    error (["%s: a tornado of %d parameters needs runs in which each of them varies for " ...
            "itself, %d or more; found %d"], who, k, k + 2, n);
  endif
  slope = (centred ./ std (s.p, 0, 1)) \ (s.z - mean (s.z));
  ends = (quantile (s.p, [0.05, 0.95], 1, 7) - mean (s.p, 1)) ./ std (s.p, 0, 1);
  bars = mean (s.z) + ends' .* slope;
  [~, order] = sort (abs (diff (bars, 1, 2)), "descend");
  bars = bars(order,:);
  share = 1 - sumsq (s.z - mean (s.z) - (centred ./ std (s.p, 0, 1)) * slope) ...
              / max (sumsq (s.z - mean (s.z)), realmin);
  said = sprintf ("%s; a linear fit explains %.3g %% of its variance", s.labels{s.at}, 100 * share);
  if (range (s.z) == 0)
    said = [s.labels{s.at} "; constant"];
  endif
  names = s.names(order);
  lines = barred (names, bars, mean (s.z), said, ...
                  {"parameter at its quantile 0.05", "at its quantile 0.95"});
  size = [16, 3.2 + 0.9 * k];
  [heads, data] = deal ({"parameter", "low", "high"}, bars);
endfunction

## a margin on the left that holds the names, in widths of a usual letter
function room = room_of (names)
  wide = @(name) numel (name) + 0.5 * sum (isupper (name)) ...
                 + 0.7 * sum (any (name == "MWmw@%"', 1));
  room = 2.5 + max (cellfun (wide, names));
endfunction

## two bars a row, from FROM on
function lines = barred (names, bars, from, said, keys)
  k = numel (names);
  y = (k:-1:1)';
  tics = strjoin (arrayfun (@(i) sprintf ("%s %d", gs.text.gnuplot_quoted (names{i}), y(i)), ...
                            1:k, "UniformOutput", false), ", ");
  lines = {"set encoding utf8", "set border 1 lc rgb '#4d4d4d'", "set tics nomirror out", ...
           ["set ytics (" tics ") noenhanced scale 0"], sprintf("set yrange [0.4:%g]", k + 0.6), ...
           sprintf("set xlabel %s", quoted (said)), ...
           sprintf("set lmargin %.3g", room_of (names)), ...
           "set tmargin 2.5", "set key at screen 0.5, screen 0.98 center top horizontal", ...
           "set style fill solid 0.85 noborder", "set offsets graph 0.04, graph 0.04, 0, 0"};
  for c = 1:2
    lines = [lines, {sprintf("$d%d << END", c), ...
                     sprintf("%.9g %d %.9g %.9g %.9g %.9g\n", ...
                             [bars(:,c), y, min(from, bars(:,c)), max(from, bars(:,c)), ...
                              y - 0.34, y + 0.34]'), "END"}];
  endfor
  lines = [lines, {sprintf(["set arrow from %.9g, graph 0 to %.9g, graph 1 nohead lc rgb " ...
                            "'#4d4d4d' front"], from, from), ...
                   sprintf(["plot $d1 with boxxyerror lc rgb '#00459a' title %s, " ...
                            "$d2 with boxxyerror lc rgb '#cc3318' title %s"], ...
                           gs.text.gnuplot_quoted (keys{1}), gs.text.gnuplot_quoted (keys{2}))}];
endfunction

function [lines, heads, data, size, names] = indices (who, w, s)
  if (! isfield (w, "first"))
    error ("%s: expected a sweep by the plan \"indices\"", who);
  endif
  k = numel (s.names);
  values = [w.first(:,s.at-k), w.total(:,s.at-k)];
  if (all (isnan (values(:))))
    error ("%s: there are no indices of %s: it is constant, or too many runs failed", who, s.name);
  endif
  [~, order] = sort (values(:,2), "descend");
  both = values(order,:);
  y = (k:-1:1)';
  names = s.names(order);
  lines = barred (names, both, 0, ["share of the variance of " s.name], ...
                  {"alone", "with all others"});
  lines(strncmp (lines, "set offsets", 11)) = {sprintf("set xrange [%.9g:*]", min ([both(:); 0]))};
  for c = 1:2   # one above the other
    at = find (strcmp (lines, sprintf ("$d%d << END", c))) + 1;
    low = y - 0.36 * (c == 2);
    lines{at} = sprintf ("%.9g %.9g %.9g %.9g %.9g %.9g\n", ...
                         [both(:,c), low + 0.18, min(0, both(:,c)), max(0, both(:,c)), low, ...
                          low + 0.34]');
  endfor
  size = [16, 3.2 + 0.9 * k];
  [heads, data] = deal ({"parameter", "first", "total"}, both);
endfunction

%!test
%! if (isempty (file_in_path (getenv ("PATH"), "gnuplot")))
%!   return;
%! endif
%! p = [1:9; [2 7 1 8 2 8 1 8 2]]';
%! w = struct ("names", {{"a", "b_1", "final y"}}, "units", {{"m", "", "m/s"}}, "values", ...
%!             [p, p(:,1) - 2 * p(:,2)], "ok", true (9, 1), "correlation", [0.5; -1], ...
%!             "first", [0.2; 0.7], "total", [0.25; 0.8]);
%! for kind = {"scatter", "tornado", "indices"}
%!   file = [tempname() ".svg"];
%!   gsmbp_sweep_plot (file, w, kind{1});
%!   assert (exist (file, "file"), 2);
%!   heads = strsplit (fgetl (f = fopen ([file(1:end-3) "csv"])), ",");
%!   fclose (f);
%!   assert (numel (heads), 3);
%!   cellfun (@delete, {file, [file(1:end-3) "csv"]});
%! endfor
%!test <names have their room, what is constant is told, the legend says what is drawn>
%! if (isempty (file_in_path (getenv ("PATH"), "gnuplot")))
%!   return;
%! endif
%! p = [1:9; [2 7 1 8 2 8 1 8 2]]';
%! w = struct ("names", {{"WW", "mm", "final y", "final z"}}, "units", {{"m", "", "m/s", ""}}, ...
%!             "values", [p, p(:,1) - 2 * p(:,2), ones(9, 1)], "ok", true (9, 1), "correlation", ...
%!             [0.5, NaN; -1, NaN], "first", [0.2, NaN; 0.7, NaN], "total", [0.25, NaN; 0.8, NaN]);
%! file = [tempname() ".svg"];
%! tidy = onCleanup (@() cellfun (@delete, {file, [file(1:end-3) "csv"]}));
%! for kind = {"tornado", "indices"}
%!   gsmbp_sweep_plot (file, w, kind{1});
%!   text = fileread (file);
%!   place = regexp (text, 'translate\(([\d.]+),[^>]*>\s*<text>(?:WW|mm)<', "tokens");
%!   assert (numel (place), 2);
%!   assert (str2double ([place{:}]) > 2 * 0.95 * 13.4);   # of the widest letter, in pixels
%!   assert (isempty (strfind (text, "quantile 0.05")), strcmp (kind{1}, "indices"));
%! endfor
%! gsmbp_sweep_plot (file, w, "scatter", "final z");
%! assert (numel (strfind (fileread (file), ">constant<")), 2);
%! gsmbp_sweep_plot (file, w, "tornado", "final z");
%! assert (numel (strfind (fileread (file), "final z; constant<")), 1);
%! fail ("gsmbp_sweep_plot (file, w, \"indices\", \"final z\")", "no indices of final z: it is");
%! w.ok(:) = false;
%! fail ("gsmbp_sweep_plot (file, w)", "came to its end and has final y, found none in 9");
%!test <tables name the parameters; small numbers are told by powers; no point lies on the frame>
%! if (isempty (file_in_path (getenv ("PATH"), "gnuplot")))
%!   return;
%! endif
%! p = [1e-6 * (1:9); [2 7 1 8 2 8 1 8 2]]';
%! w = struct ("names", {{"a", "b_1", "final y"}}, "units", {{"m", "", "m/s"}}, "values", ...
%!             [p, 1e6 * p(:,1) - 2 * p(:,2)], "ok", true (9, 1), "correlation", [0.5; -1], ...
%!             "first", [0.2; 0.7], "total", [0.25; 0.8]);
%! file = [tempname() ".svg"];
%! tidy = onCleanup (@() cellfun (@delete, {file, [file(1:end-3) "csv"]}));
%! heads = {"parameter,low,high", "parameter,first,total"};
%! for kind = {"tornado", "indices"; heads{:}}
%!   gsmbp_sweep_plot (file, w, kind{1});
%!   text = strsplit (fileread ([file(1:end-3) "csv"]), "\n");
%!   assert (text{1}, kind{2});
%!   assert (sort (strtok (text(2:3), ",")), {"a", "b_1"});
%! endfor
%! gsmbp_sweep_plot (file, w, "scatter");
%! text = fileread (file);
%! assert (numel (strfind (text, "\302\26710")), 2);   # marks of the first axis, no others
%! ends = cellfun (@str2num, regexp (text, 'd=.M([\d.]+),([\d.]+) L', "tokens"){1});
%! places = regexp (text, 'xlink:href=.#gpPt6. transform=.translate\(([\d.]+),', "tokens");
%! assert (numel (places), 18);
%! assert (min (str2double ([places{1:9}])) > ends(1) + 3);   # pixels
%!error <expected a result of gsmbp_sweep> gsmbp_sweep_plot ("a.png", 3)
