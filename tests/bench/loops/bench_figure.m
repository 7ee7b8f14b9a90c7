## bench_figure (file, panels, xlabel): speed against error, a panel for each mechanism, three in a
## row, the names of the curves below. bench_figure (file, panels, xlabel, ylabel, style): the same
## for other quantities, in gnuplot's style (default linespoints).
##
## panels: struct array with title and curves, a struct array with name, color, x (time), y (error).
## The numbers go into the .csv beside FILE.

function bench_figure (file, panels, xlabel, ylabel = "largest error [rad, m]", ...
                       style = "linespoints")
  columns = min (3, numel (panels));
  lines = ceil (numel (panels) / columns);
  [width, height] = deal (380, 320);
  if (numel (panels) == 1)
    [width, height] = deal (620, 420);
  end
  names = unique (cellfun (@(c) {c.name}, {panels.curves}, "UniformOutput", false){1}, "stable");
  foot = 25 + 22 * ceil (numel (names) / floor (columns * width / 130));
  tall = lines * height + foot;
  text = {sprintf("set terminal pngcairo noenhanced size %d,%d font 'FreeSans,11'", ...
                  columns * width, tall), sprintf("set output '%s.new'", file), ...
          "set logscale xy", ["set format xy '" {"%.0e", "%g"}{1 + (nargin > 3)} ...
                                "'"], "set grid lc rgb '#cccccc'", "set multiplot", "unset key", ...
                                    "set xtics font ',9'", "set ytics font ',9'"};
  csv = {"mechanism,way,time_s,error\n", sprintf("panel,curve,%s,%s\n", xlabel, ylabel)}{1 ...
        + (nargin > 3)};
  names = colors = {};
  for k = 1:numel (panels)
    left = mod (k - 1, columns) * width;
    top = tall - floor ((k - 1) / columns) * height;
    text{end+1} = ...
        sprintf (["set title \"%s\"\nset lmargin at screen %g\nset rmargin at screen %g\nset " ...
                  "tmargin at screen %g\nset bmargin at screen %g"], panels(k).title,
                           (left + 75) / (columns * width), (left + width - 15) / (columns ...
                                 * width), (top - 30) / tall, (top - height + 55) / tall);
    text{end+1} = sprintf ("set xlabel '%s'\nset ylabel '%s'", xlabel, ...
                           {ylabel, ""}{1 + (mod (k - 1, columns) > 0)});
    plots = data = {};
    for one = panels(k).curves
      good = isfinite (one.x) & isfinite (one.y);
      rows = [one.x(good); max(one.y(good), 1e-17)];
      csv = [csv, ...
             cellfun(@(v) sprintf ("%s,%s,%.6g,%.6g\n", panels(k).title, one.name, v), ...
                     num2cell (rows, 1), "UniformOutput", false){:}];
      if (! any (strcmp (names, one.name)))
        names{end+1} = one.name;
        colors{end+1} = one.color;
      end
      if (any (good))
        plots{end+1} = sprintf ("'-' with %s %spt 7 ps 0.8 lc rgb '%s'", style, ...
                                {"lw 2 ", ""}{1 + strcmp(style, "points")}, one.color);
        data{end+1} = [sprintf("%g %g\n", rows), "e"];
      end
    end
    text{end+1} = ["plot " strjoin(plots, ", ") "\n" strjoin(data, "\n")];
  end
  text{end+1} = legend_of (names, colors, columns * width, tall, foot);
  text{end+1} = "unset multiplot";
  bench_save ([file(1:end-4) ".csv"], csv);
  bench_save ([file(1:end-4) ".gp"], [strjoin(text, "\n") "\n"]);
  if (system (sprintf ("gnuplot '%s.gp' && mv '%s.new' '%s'", file(1:end-4), file, file)) != 0)
    error ("bench: gnuplot failed on %s", file);
  end
end

## the names at the foot, as many in a line as find room, each behind a piece of its curve
function text = legend_of (names, colors, width, tall, foot)
  text = ...
      ["unset title\nunset xlabel\nunset ylabel\nunset tics\nunset border\nunset grid\nunset " ...
       "logscale\nset xrange [0:1]\nset yrange [0:1]\n" ...
          "set lmargin at screen 0\nset rmargin at screen 1\nset tmargin at screen 1\nset " ...
          "bmargin at screen 0\n"];
  room = floor (width / 130);
  for k = 1:numel (names)
    x = (mod (k - 1, room) * 130 + 20) / width;
    y = (foot - 25 - 22 * floor ((k - 1) / room)) / tall;
    text = [text, ...
            sprintf(["set arrow from %g,%g to %g,%g nohead lw 3 lc rgb '%s'\nset label '%s' at " ...
                     "%g,%g left\n"], x, y, x + 25 / width, y, colors{k}, names{k}, ...
                    x + 32 / width, y)];
  end
  text = [text, "set label ' ' at 0,0\nplot [0:1] [0:1] -1 notitle"];
end
