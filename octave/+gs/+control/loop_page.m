## gs.control.loop_page (who, file, c, w, L, margins, mc, run, size_)
## The page of gsmbp_loop: Bode, Nyquist, root locus, responses in time, as panels of one figure.

function loop_page (who, file, c, w, L, margins, mc, run, size_)
  [~, ~, kind] = fileparts (file);
  if (! any (strcmpi (kind, {".png", ".pdf", ".svg", ".eps"})))
    error ("%s: the file must end in .png, .pdf, .svg or .eps, found: %s", who, file);
  endif
  if (numel (size_) != 2 || any (size_ < 8) || any (size_ > 200))
    error ("%s: option size: expected width and height from 8 to 200 cm, found %s", who, ...
           gs.text.shown_value (size_));
  endif
  [in_time, aside] = gs.control.drawn_responses (gs.control.step_responses (who, c, mc, run));
  lines = {"set encoding utf8", "set grid lc rgb '#c8c8c8' lw 0.6 dt 1", "set border lw 0.8", ...
           "set key top right samplen 3 spacing 1.1 noenhanced opaque", ...
           sprintf(["set multiplot layout 3,2 title %s noenhanced " ...
                    "margins 0.08,%g,0.05,0.93 spacing %g,0.08"], ...
                   gs.text.gnuplot_quoted (heading (c, margins)), [0.97, 0.1] + aside * [-0.06, ...
                       0.08])};
  lines = [lines, bode(c, w, L, margins), nyquist(c, L, margins), locus(c), in_time];
  lines{end+1} = "unset multiplot";
  table = gs.files.new_beside (who, [file(1:end-numel (kind)) ".csv"]);
  names = [strcat({"real of L at "}, c.driven(:)'); strcat({"imaginary of L at "}, c.driven(:)')];
  gsmbp_csv (table, [{"frequency [rad/s]"}, names(:)'], ...
             [w', reshape([real(L'); imag(L')](:), numel (w), [])]);
  gs.files.run_gnuplot (who, file, terminal (tolower (kind), size_), lines, table);
endfunction

function text = heading (c, margins)
  [~, k] = max ([margins.Ms]);
  one = margins(k);
  at = "";
  if (numel (margins) > 1)
    at = [" at " c.driven{k}];
  endif
  text = sprintf (["%s (%s)%s: phase margin %.1f\302\260, gain margin %.3g, Ms %.3g, delay " ...
                   "margin %.3g s"], c.name, c.method, at, abs (one.phase) * 180 / pi, one.gain, ...
                  one.Ms, one.delay);
  if (c.period > 0)
    text = [text sprintf("; period %.3g s, delay %.3g s", c.period, c.delay)];
  endif
endfunction

function text = terminal (kind, s)
  switch (kind)
    case ".png"
      text = sprintf ("pngcairo size %d,%d fontscale 1.2 linewidth 1.2", round (s * 150 / 2.54));
    case {".pdf", ".eps"}
      text = sprintf ("%scairo size %.3fcm,%.3fcm fontscale 0.7 linewidth 1", kind(2:4), s);
    case ".svg"
      text = sprintf ("svg size %d,%d fontscale 1.2 linewidth 1", round (s * 96 / 2.54));
  endswitch
  text = [text " enhanced font 'FreeSans,9'"];
endfunction

function text = curve (name, columns_, k, title)
  colors = gs.draw.line_colors (k);
  text = sprintf ("$%s using %s with lines lw 1.8 dt %d lc rgb '%s' title %s", name, columns_, ...
                  mod (k - 1, 4) + 1, colors{k}, gs.text.gnuplot_quoted (title));
endfunction

function lines = bode (c, w, L, margins)
  n = rows (L);
  phase = unwrap (angle (L), [], 2);
  for i = 1:n   # at the crossover between -270 and 90 degrees
    [~, k] = min (abs (log (abs (L(i,:)))));
    phase(i,:) -= 2 * pi * round ((phase(i,k) + pi / 2) / (2 * pi));
  endfor
  keep = shown (L, w, margins);
  lines = gs.draw.data_block ("L", [w(keep)', abs(L(:,keep)).', phase(:,keep).' * 180 / pi]);
  lines = [lines, {"set logscale xy", "set format xy '10^{%T}'", ...
                   "set xlabel 'frequency [rad/s]'", ...
                   "set ylabel '|L| [1]'", "set title 'Bode: magnitude'", ...
                   sprintf("set xrange [%.9g:%.9g]", w(keep)([1, end])), "set yrange [*:*]"}];
  list = {};
  for i = 1:n
    list{end+1} = curve ("L", sprintf ("1:%d", 1 + i), i, c.driven{i});
    lines{end+1} = arrow (10 + i, margins(i).crossover, i);
  endfor
  lines{end+1} = ["plot 1 with lines lw 1 lc rgb '#4d4d4d' notitle, " strjoin(list, ", ")];
  list = {};
  for i = 1:n
    list{end+1} = curve ("L", sprintf ("1:%d", 1 + n + i), i, c.driven{i});
  endfor
  shown_phase = phase(:,keep) * 180 / pi;
  low = max (-720, 90 * floor (min (shown_phase(:)) / 90));
  high = min (360, 90 * ceil (max (shown_phase(:)) / 90 + 1e-9));
  lines = [lines, {"unset logscale y", "set format y '%g'", "set ylabel 'arg L [degrees]'", ...
                   "set title 'Bode: phase'", sprintf("set yrange [%g:%g]", low, high), ...
                   sprintf("set ytics %g", max (45, 45 * ceil ((high - low) / 450))), ...
                   ["plot -180 with lines lw 1 lc rgb '#4d4d4d' notitle, " strjoin(list, ", ")], ...
                   "unset logscale", "set format xy '%g'", "set ytics autofreq", "unset arrow"}];
endfunction

## a line at a crossover
function text = arrow (k, at, i)
  text = "";
  if (isfinite (at))
    color = gs.draw.line_colors (i);
    text = sprintf (["set arrow %d from first %.9g, graph 0 to first %.9g, graph 1 nohead " ...
                     "lw 0.8 dt 3 lc rgb '%s'"], k, at, at, color{i});
  endif
endfunction

## frequencies about the crossovers: three decades
function keep = shown (L, w, margins)
  at = [margins.crossover, margins.phase_crossover, margins.Ms_at];
  at = at(isfinite (at) & at > 0);
  keep = true (size (w));
  if (! isempty (at))
    keep = w >= min (at) / 100 & w <= max (at) * 100;
  endif
endfunction

function lines = nyquist (c, L, margins)
  a = linspace (0, 2 * pi, 181)';
  Ms = max ([margins.Ms]);
  lines = [gs.draw.data_block("C", [cos(a), sin(a), -1 + cos(a) / Ms, sin(a) / Ms])];
  near = L;
  near(abs (near) > 20) = NaN;
  lines = [lines, gs.draw.data_block("N", [real(near.'), imag(near.')])];
  n = rows (L);
  list = {"$C using 1:2 with lines lw 0.8 dt 3 lc rgb '#4d4d4d' notitle", ...
          sprintf("$C using 3:4 with lines lw 0.8 lc rgb '#cc3318' title '1/Ms'"), ...
          "'+' every ::0::0 using (-1):(0) with points pt 2 ps 1.2 lc rgb '#cc3318' notitle"};
  for i = 1:n
    list{end+1} = curve ("N", sprintf ("%d:%d", i, n + i), i, c.driven{i});
  endfor
  lines = [lines, {"set size ratio -1", "set xrange [-4.2:2.5]", "set yrange [-2.2:2.2]", ...
                   "set xlabel 'Re L [1]'", "set ylabel 'Im L [1]'", "set title 'Nyquist'", ...
                   ["plot " strjoin(list, ", ")], "set size noratio", "set xrange [*:*]", ...
                   "set yrange [*:*]"}];
endfunction

function lines = locus (c)
  [F, H, S] = deal (c.plant.a, c.plant.b, c.plant.c);
  ny = rows (S);
  [By, Dy] = deal (c.B(:,1:ny), c.D(:,1:ny));
  gains = [0, logspace(-3, 1, 1200)];
  poles = zeros (rows (F) + rows (c.A), numel (gains));
  ## G and observers know what is given: they are parts of A
  for k = 1:numel (gains)
    poles(:,k) = eig ([F + gains(k) * H * Dy * S, gains(k) * H * c.C; By * S, c.A]);
  endfor
  closed = eig ([F + H * Dy * S, H * c.C; By * S, c.A]);
  lines = [gs.draw.data_block("R", [real(poles(:)), imag(poles(:))]), ...
           gs.draw.data_block("O", [real(poles(:,1)), imag(poles(:,1))]), ...
           gs.draw.data_block("P", [real(closed), imag(closed)])];
  range = window (closed, poles(:,1), c.period);
  list = {"$R using 1:2 with points pt 7 ps 0.15 lc rgb '#00459a' notitle", ...
          "$O using 1:2 with points pt 2 ps 1 lc rgb '#4d4d4d' title 'gain 0'", ...
          "$P using 1:2 with points pt 6 ps 1.1 lc rgb '#cc3318' title 'closed'"};
  name = "s [1/s]";
  without = "";
  if (c.period == 0 && c.delay > 0)
    without = ", dead time left out";
  endif
  if (c.period > 0)
    a = linspace (0, 2 * pi, 361)';
    lines = [lines, gs.draw.data_block("U", [cos(a), sin(a)])];
    list{end+1} = "$U using 1:2 with lines lw 0.8 lc rgb '#4d4d4d' notitle";
    name = "z [1]";
  endif
  lines = [lines, {sprintf("set xrange [%.9g:%.9g]", range(1:2)), ...
                   sprintf("set yrange [%.9g:%.9g]", range(3:4)), ...
                   sprintf("set xlabel 'Re %s'", name), sprintf("set ylabel 'Im %s'", name), ...
                   sprintf("set title 'Root locus: all gains from 0 to 10 times%s'", without), ...
                   ["plot " strjoin(list, ", ")], "set xrange [*:*]", "set yrange [*:*]"}];
endfunction

## what is shown of the plane: closed poles and those of gain 0, without far ones
function r = window (closed, open_, h)
  if (h > 0)
    all_ = [closed; open_];
    all_ = all_(abs (all_) < 3);
    if (any (abs (all_) > 0.7))   # not those of inputs on their way
      all_ = all_(abs (all_) > 0.5);
    endif
    inner = min ([real(all_); 0.9]);
    high = max ([abs(imag (all_)); 0.1]);
    right = max ([real(all_); 1]);
    width = right - inner;
    r = [inner - 0.1 * width, right + 0.1 * width, -1.2 * high, 1.2 * high];
    return;
  endif
  far = 4 * median (abs (closed));
  all_ = [closed(abs (closed) <= far); open_(abs (open_) <= far)];
  [a, b] = deal (min (real (all_)), max ([real(all_); 0]));
  high = max ([abs(imag (all_)); 0.2 * (b - a)]);
  r = [a - 0.15 * (b - a), b + 0.15 * (b - a), -1.3 * high, 1.3 * high];
endfunction
