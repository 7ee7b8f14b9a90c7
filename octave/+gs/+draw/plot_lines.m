## lines = gs.draw.plot_lines (table, panels, o, size)
## What gnuplot is told to draw the panels from the file TABLE, one above the other, SIZE [cm]: the
## legend above each, curves that differ without their colours, none hidden by another.  o: the
## options of gsmbp_plot, and limits, the ends of the abscissa.

function lines = plot_lines (table, panels, o, size)
  n = numel (panels);
  em = 0.176 * o.fontsize / 10;   # [cm], of a letter
  top = 0.25 + 0.75 * (! isempty (o.title));
  below = 1.3 * o.fontsize / 10;
  keys = cellfun (@(p) key_rows (p, size(1), em), panels);
  headed = cellfun (@(p) isfield (p, "heading") && ! isempty (p.heading), panels);
  each = (size(2) - top - below - sum (keys + headed) * 2.6 * em - (n - 1) * 0.45) / n;
  labels = cellfun (@(p) broken (gs.text.plot_label (p.label), each / em), panels, ...
      "UniformOutput", ...
                    false);
  two_lines = any (cellfun (@(text) any (text == "\n"), labels));
  left = (2.1 + 0.5 * two_lines) * o.fontsize / 10 / size(1);
  lines = {"set datafile separator comma", "set datafile missing 'NaN'", ...
           "set encoding utf8", "set grid lc rgb '#c8c8c8' lw 0.6 dt 1", "set border lw 0.8", ...
           sprintf("set lmargin at screen %.4f", left), ...
           sprintf("set rmargin at screen %.4f", 1 - 0.45 / size(1)), axes_of(o.scale)};
  if (any (strcmp (o.scale, {"linear", "semilogy"})))
    lines{end+1} = "set autoscale xfix";
    if (all (isfinite (o.limits)) && diff (o.limits) > 0)   # the same where curves have gaps
      lines{end+1} = sprintf ("set xrange [%.17g:%.17g]", o.limits);
    endif
  endif
  if (any (strcmp (o.scale, {"linear", "semilogx"})))   # no curve on the frame
    lines{end+1} = "set offsets graph 0, graph 0, graph 0.03, graph 0.03; set autoscale yfix";
  endif
  lines{end+1} = "set multiplot";
  at = size(2) - top;
  if (! isempty (o.title))
    lines{end+1} = label_at (1, o.title, [(left + 1) / 2, 1 - 0.6 / size(2)], ...
                             sprintf ("center font ',%.1f'", 1.1 * o.fontsize ...
                                      * min (1, size(1) * 0.9 / (numel (o.title) * 0.8 * em))));
  endif
  column = 2;
  for i = 1:n
    p = panels{i};
    if (headed(i))
      lines{end+1} = label_at (2, p.heading, [left, (at - 1.2 * em) / size(2)], "left");
    endif
    at -= (keys(i) + headed(i)) * 2.6 * em;
    lines = [lines, place(at, each, size, i == n, o), {key_of(p, keys(i), size)}];
    lines{end+1} = sprintf ("set ylabel %s offset %g noenhanced", ...
                            strrep (gs.text.gnuplot_quoted (labels{i}), "\n", "'.\"\\n\".'"), ...
                            0.8 - 1.6 * any (labels{i} == "\n"));
    lines{end+1} = ["plot " curves(table, p, column)];
    lines{end+1} = "unset label";
    column += columns (p.y);
    at -= each + 0.45;
  endfor
  lines{end+1} = "unset multiplot";
endfunction

## a label in two lines where it has more letters than the axis has room for
function text = broken (text, room)
  blanks = find (text == " ");
  if (numel (text) > room && ! isempty (blanks))
    [~, k] = min (abs (blanks - numel (text) / 2));
    text(blanks(k)) = "\n";
  endif
endfunction

function line = label_at (k, text, at, how)
  line = sprintf ("set label %d %s at screen %.4f,%.4f %s noenhanced", k, ...
      gs.text.gnuplot_quoted (text), ...
                  at, how);
endfunction

function lines = place (at, each, size, last, o)
  lines = {sprintf("set tmargin at screen %.4f", at / size(2)), ...
           sprintf("set bmargin at screen %.4f", (at - each) / size(2))};
  if (last)
    label = gs.text.gnuplot_quoted (gs.text.plot_label (o.xlabel));
    lines = [lines, {format_of(o.scale), sprintf("set xlabel %s offset 0,0.3 noenhanced", label)}];
  else
    lines{end+1} = "set format x ''";
  endif
endfunction

function line = format_of (scale)
  line = "set format x";
  if (any (strcmp (scale, {"semilogx", "loglog"})))
    line = "set format x '10^{%T}'";
  endif
endfunction

## rows of the legend; a curve alone whose label says its name needs none
function rows = key_rows (p, width, em)
  rows = 0;
  if (numel (p.names) > 1 || isempty (strfind (p.label, p.names{1})))
    entry = (max (cellfun (@numel, p.names)) + wider (p.names)) * em * 1.15 + 1.6;
    across = max (1, min (numel (p.names), floor ((width - 2.6) / entry)));
    rows = ceil (numel (p.names) / across);
  endif
endfunction

function text = key_of (p, rows, size)
  text = "unset key";
  if (rows > 0)
    text = sprintf (["set key at graph 0.5,1.02 center bottom horizontal Left reverse " ...
                     "noenhanced samplen 4 spacing 1.1 maxrows %d width %.2g"], rows, ...
                    wider (p.names));
  endif
endfunction

## by how many letters the names are longer than gnuplot takes them to be, where these are wide
function n = wider (names)
  by = @(name) 0.45 * sum (isupper (name)) + 0.4 * sum (any (name == "MWmw@%"', 1));
  n = max (cellfun (by, names));
endfunction

## each curve thinner than the one before, and with more gaps, so that both are seen where they meet
function text = curves (table, p, column)
  factor = 1;
  if (isfield (p, "factor"))
    factor = p.factor;
  endif
  n = columns (p.y);
  styles = repmat ({"lines"}, 1, n);
  if (isfield (p, "style"))
    styles(:) = p.style;
  endif
  colors = gs.draw.line_colors (n);
  list = cell (1, n);
  for k = 1:n
    list{k} = sprintf ("%s using 1:(%.17g*column(%d)) skip 1 with %s lc rgb '%s' %s title %s", ...
                       gs.text.gnuplot_quoted (table), factor, column + k - 1, styles{k}, ...
                           colors{k}, ...
                       kind_of (k, n, styles{k}), gs.text.gnuplot_quoted (p.names{k}));
  endfor
  text = strjoin (list, ", ");
endfunction

function text = kind_of (k, n, style)
  dashes = {"1", "(9,5)", "(3,3)", "(9,4,2,4)", "(16,5)", "(4,4)", "(16,4,2,4,2,4)"};
  marks = [7, 6, 5, 4, 9, 8, 13];
  width = max (1.8, 2.6 - 0.3 * (k - 1));
  if (n == 1)
    width = 2;
  endif
  dash = dashes{mod(k - 1, numel (dashes)) + 1};
  if (strcmp (style, "points"))
    dash = "1";
  endif
  text = sprintf ("lw %.2f dt %s pt %d ps 0.8", width, dash, marks(mod (k - 1, numel (marks)) + 1));
  if (any (strcmp (style, {"lines", "steps", "fsteps"})))
    text = sprintf ("lw %.2f dt %s", width, dash);
  endif
endfunction

function text = axes_of (scale)
  text = struct ("linear", "", "semilogy", "set logscale y; set format y '10^{%T}'", "semilogx", ...
                 "set logscale x; set format x '10^{%T}'", "loglog", ...
                 "set logscale xy; set format xy '10^{%T}'").(scale);
endfunction
