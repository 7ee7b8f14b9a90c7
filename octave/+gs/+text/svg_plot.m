## text = gs.text.svg_plot (title, x, y, names, labels, scale)
## A figure as SVG: lines Y (a column each, NAMES) over X, LABELS of the axes {x, y} with their
## units, SCALE "linear" or "log" (both axes, points marked; X then has a column for each line).
## Colours differ, and so do dashes, for grey print.

function text = svg_plot (title, x, y, names, labels, scale = "linear")
  s = stage (x, y, names, scale);
  text = [sprintf(["<div class=\"picture\"><svg xmlns=\"http://www.w3.org/2000/svg\" " ...
                   "role=\"img\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" " ...
                   "data-x=\"%.17g %.17g\" data-y=\"%.17g %.17g\" " ...
                   "data-box=\"%d %d %d %d\">\n<title>%s</title>\n"], s.size, s.size, s.xlim, ...
                  s.ylim, s.box, gs.text.html_escaped (title)), ...
          axes_of(s, labels), lines_of(s, x, y), legend_of(s, names), ...
          sprintf("</svg></div>\n")];
endfunction

## sizes, limits, ticks; box: left, top, right, bottom of what the lines fill
function s = stage (x, y, names, scale)
  s.log = strcmp (scale, "log");
  entry = 8.2 * max (cellfun (@numel, names)) + 52;
  s.across = max (1, floor (740 / entry));
  s.entry = 740 / s.across;
  below = 62 + 20 * ceil (numel (names) / s.across) * (numel (names) > 1);
  s.size = [860, 270 + below];
  s.box = [84, 14, 840, 270];
  [s.xlim, s.xticks] = limits (x, s.log, false);
  [s.ylim, s.yticks] = limits (y, s.log, true);
endfunction

function [lim, ticks] = limits (v, logarithmic, wider)
  v = v(isfinite (v));
  if (logarithmic)
    v = log10 (v(v > 0));
  endif
  if (isempty (v))
    v = [0, 1];
  endif
  low = min (v(:));
  high = max (v(:));
  if (high - low <= 1e-12 * max (abs ([low, high])))
    pad = 0.5 * abs (high) + (high == 0);
    [low, high] = deal (low - pad, high + pad);
  elseif (wider || logarithmic)
    [low, high] = deal (low - 0.04 * (high - low), high + 0.04 * (high - low));
  endif
  step = 10 ^ floor (log10 ((high - low) / 5));
  step *= [1 2 5 10](find ((high - low) ./ (step * [1 2 5 10]) <= 7, 1));
  if (logarithmic)
    step = max (1, ceil ((high - low) / 6));
  endif
  ticks = (ceil (low / step - 1e-9):floor (high / step + 1e-9)) * step;
  if (logarithmic && high - low < 2)
    ticks = log10 ([1; 2; 5] * 10 .^ (floor (low):ceil (high)))(:)';
    ticks = ticks(ticks >= low & ticks <= high);
  endif
  lim = [low, high];
endfunction

## points of the picture
function [px, py] = pixels (s, x, y)
  if (s.log)
    [x, y] = deal (log10 (x), log10 (y));
  endif
  px = s.box(1) + (x - s.xlim(1)) / diff (s.xlim) * (s.box(3) - s.box(1));
  py = s.box(4) - (y - s.ylim(1)) / diff (s.ylim) * (s.box(4) - s.box(2));
endfunction

function text = axes_of (s, labels)
  text = sprintf ("<g stroke=\"#ddd\">");
  at = @(v, lim, a, b) a + (v - lim(1)) / diff (lim) * (b - a);
  px = at (s.xticks, s.xlim, s.box(1), s.box(3));
  py = at (s.yticks, s.ylim, s.box(4), s.box(2));
  sides = repmat (s.box([2; 4])', 1, numel (px));
  text = [text, sprintf("<path d=\"M%.1f %dV%d\" />", [px; sides]), ...
          sprintf("<path d=\"M%d %.1fH%d\" />", [repmat(s.box(1), 1, numel (py)); py; ...
                                               repmat(s.box(3), 1, numel (py))]), "</g>\n", ...
          sprintf(["<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"none\" " ...
                   "stroke=\"#444\" />\n"], s.box(1:2), s.box(3:4) - s.box(1:2)), ...
          "<g text-anchor=\"middle\">"];
  for k = 1:numel (px)
    text = [text, sprintf("<text x=\"%.1f\" y=\"%d\">%s</text>", px(k), s.box(4) + 18, ...
                          written(s.xticks(k), s))];
  endfor
  text = [text, sprintf("<text x=\"%.0f\" y=\"%d\">%s</text>", mean (s.box([1 3])), ...
                        s.box(4) + 38, gs.text.html_escaped (labels{1})), ...
          sprintf("<text transform=\"translate(16 %.0f) rotate(-90)\">%s</text></g>\n", ...
                  mean (s.box([2 4])), gs.text.html_escaped (labels{2})), ...
                      "<g text-anchor=\"end\">"];
  for k = 1:numel (py)
    text = [text, sprintf("<text x=\"%d\" y=\"%.1f\">%s</text>", s.box(1) - 6, py(k) + 4, ...
                          written(s.yticks(k), s))];
  endfor
  text = [text, sprintf("</g>\n")];
endfunction

## a number at a tick
function text = written (v, s)
  if (s.log)
    text = sprintf ("%.3g", 10 ^ v);
  else
    text = strrep (sprintf ("%.6g", v + 0), "-", "&#x2212;");
  endif
endfunction

function [color, dashes] = style (k)
  colors = {"#0b5fa5", "#c8501e", "#2a7f3f", "#7a3e9d", "#a3821a", "#0f8a8f", "#b0306a", "#555555"};
  kinds = {"", "7 3", "2 3", "9 3 2 3", "12 4", "4 2", "1 2", "9 3 2 3 2 3"};
  color = colors{mod(k - 1, 8) + 1};
  dashes = kinds{mod(k - 1, 8) + 1};
endfunction

function text = lines_of (s, x, y)
  text = "";
  for k = 1:columns (y)
    [px, py] = pixels (s, x(:,min (k, columns (x))), y(:,k));
    fine = isfinite (px) & isfinite (py);
    [color, dashes] = style (k);
    points = sprintf ("%.1f,%.2f ", [px(fine), py(fine)]');
    text = [text, sprintf(["<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\" " ...
                           "stroke-dasharray=\"%s\" points=\"%s\" />\n"], color, ...
                          [dashes, "none"(1:4*isempty (dashes))], strtrim (points))];
    if (s.log)
      text = [text, sprintf(["<circle cx=\"%.1f\" cy=\"%.2f\" r=\"3.5\" fill=\"" color "\" />"], ...
                            [px(fine), py(fine)]')];
    endif
  endfor
endfunction

function text = legend_of (s, names)
  text = "";
  if (numel (names) < 2)
    return;
  endif
  for k = 1:numel (names)
    [color, dashes] = style (k);
    x = s.box(1) + s.entry * mod (k - 1, s.across);
    y = s.box(4) + 60 + 20 * floor ((k - 1) / s.across);
    text = [text, sprintf(["<path d=\"M%.0f %dh34\" stroke=\"%s\" stroke-width=\"2\" " ...
                           "stroke-dasharray=\"%s\" />" ...
                           "<text x=\"%.0f\" y=\"%d\">%s</text>\n"], x, y - 4, color, ...
                          [dashes, "none"(1:4*isempty (dashes))], x + 40, y, ...
                          gs.text.html_escaped (names{k}))];
  endfor
endfunction
