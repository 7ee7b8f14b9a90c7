## film (FILE, FRAMES, OPTION, VALUE, ...)
## Draws bodies in space, without a screen, by the curves that make them: what gsmbp_animate does
## not know, as the thread of a screw or the forks of a joint.
##
## FRAMES is a cell array, one entry for each picture: a cell array with a row {P, STYLE, NAME} for
## each curve. P is 3 x n [m], ground axes; a column of NaN separates pieces. STYLE is gnuplot's, as
## "lines lw 2 lc rgb 'black'"; NAME stands in the legend ("": not there). FILE ends in .gif (all
## pictures, again and again) or .png (one). Parallel projection; the axes in the corner are as long
## as they say. Options: "view" [turn, height] in degrees: the axis x points to the right, the eye
## in direction -y, turned about z, and raised; 90 is from above; "width" [pixels], "fps", "titles"
## (a cell array), "axis" its length [m], "margin" (times the size).

function film (file, frames, varargin)
  o = struct ("view", [30, 25], "width", 480, "fps", 20, "titles", {{}}, "axis", 0, "margin", 0.04);
  for k = 1:2:numel (varargin)
    o.(varargin{k}) = varargin{k+1};
  endfor
  [c, s] = deal (cosd (o.view), sind (o.view));
  look = [c(1), s(1), 0; -s(1)*s(2), c(1)*s(2), c(2)];
  all_points = look ...
      * cell2mat (cellfun (@(f) cell2mat (f(:,1)'), frames(:)', "UniformOutput", false));
  low = min (all_points, [], 2);
  high = max (all_points, [], 2);
  edge = o.margin * max (high - low);
  height = round (o.width * (high(2) - low(2) + 2*edge) / (high(1) - low(1) + 2*edge)) + 50;
  terminal = "pngcairo noenhanced";
  if (strcmp (file(end-3:end), ".gif"))
    terminal = sprintf ("gif animate optimize delay %d loop 0 noenhanced", round (100 / o.fps));
  endif
  script = [tempname() ".gp"];
  f = fopen (script, "w");
  fprintf (f, "set terminal %s size %d,%d font 'FreeSans,11'\nset output '%s'\n", terminal, ...
           o.width, height, file);
  fprintf (f, "set xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\nset size ratio -1\n", ...
           low(1) - edge, high(1) + edge, low(2) - edge, high(2) + edge);
  fprintf (f, ...
           ["unset border\nunset tics\nset lmargin 0\nset rmargin 0\nset tmargin at " ...
            "screen %.5f\nset bmargin at screen %.5f\n"], 1 - 25 / height, 25 / height);
  fprintf (f, "set key at screen 0.5,%.5f center horizontal maxrows 1 samplen 2\n", 12 / height);
  if (o.axis > 0)
    corner = low;
    tips = o.axis * look;
    corner -= min ([1.3 * tips, zeros(2, 1)], [], 2);
    for k = 1:3
      fprintf (f, ...
               ["set arrow from %.9g,%.9g rto %.9g,%.9g size graph 0.012,25 lc rgb " ...
                "'#888888'\n"], corner, tips(:,k));
      fprintf (f, "set label '%s' at %.9g,%.9g center tc rgb '#888888'\n", "xyz"(k), ...
               corner + 1.2 * tips(:,k));
    endfor
    fprintf (f, "set label 'axes: %g m' at screen 0.01,%.5f tc rgb '#888888'\n", o.axis, ...
             1 - 12 / height);
  endif
  for n = 1:numel (frames)
    if (! isempty (o.titles))
      fprintf (f, "set label 9 '%s' at screen 0.5,%.5f center\n", o.titles{n}, 1 - 12 / height);
    endif
    plots = {};
    for k = 1:rows (frames{n})
      fprintf (f, "$C%d << EOD\n%sEOD\n", k, ...
               regexprep (sprintf ("%.5g %.5g\n", look * frames{n}{k,1}), "NaN[^\n]*", ""));
      plots{k} = sprintf ("$C%d with %s %s", k, frames{n}{k,2}, ...
                          {"notitle", ["title '" frames{n}{k,3} "'"]}{1 ...
                              + ! isempty(frames{n}{k,3})});
    endfor
    fprintf (f, "plot %s\n", strjoin (plots, ", "));
  endfor
  fclose (f);
  [status, text] = system (["gnuplot " script " 2>&1"]);
  unlink (script);
  if (status != 0)
    error ("film: %s: %s", file, text);
  endif
endfunction
