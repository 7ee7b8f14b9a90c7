## text = gs.report.motion_player (who, m, r, drawing, o)
## The player of a motion as a section of a page: the drawing of one instant as SVG, what is drawn
## as JSON with the poses as float32, and the script of share/report.  "" without a drawing.

function text = motion_player (who, m, r, drawing, o)
  text = "";
  if (isempty (drawing))
    return;
  endif
  list = instants (r.t(:), o.frames);
  [number, place, turn] = gs.report.drawn_poses (who, drawing, m, r, list);
  d = gs.report.drawn_scene (drawing, number, place, turn, r.t(:)(list));
  poses = cellfun (@(p, R) [R, p], place, turn, "UniformOutput", false);
  poses = [repmat([1 0 0 0 1 0 0 0 1 0 0 0], numel (list), 1), poses{:}];
  data = d;
  data.poses = base64_encode (single (poses'(:)));
  data.arrows_v = base64_encode (single (d.arrows_v'(:)));
  data.axes_of_beams = base64_encode (single (d.axes_of_beams'(:)));
  script = fileread (gs.files.own_place ("share", "report", "player.js"));
  json = strrep (strrep (jsonencode (data), "&", '\u0026'), "<", '\u003c');
  text = [sprintf("<h2>The motion</h2>\n<div class=\"player\">\n"), controls(d), ...
          gs.report.still_picture(d, place, turn), sprintf("</div>\n"), ...
          "<script type=\"application/json\" id=\"motion\">", json, ...
          sprintf("</script>\n<script>\n//<![CDATA[\n%s//]]>\n</script>\n", script)];
endfunction

## the rows nearest to equal steps
function list = instants (t, most)
  n = min (numel (t), max (2, round (most)));
  list = unique (interp1 (t, 1:numel (t), linspace (t(1), t(end), n), "nearest"));
endfunction

function text = controls (d)
  pace = "";
  for speed = [0.1 0.25 0.5 1 2 5]
    pace = [pace, sprintf("<option value=\"%g\"%s>%g</option>", speed, ...
                          " selected=\"selected\""(1:20*(speed == 1)), speed)];
  endfor
  text = [sprintf(["<p id=\"controls\"><button id=\"play\">pause</button> " ...
                   "<label>time <input type=\"range\" id=\"time\" min=\"0\" " ...
                   "max=\"%d\" value=\"0\" " ...
                   "step=\"1\" /></label> " ...
                   "<output id=\"now\">%.3f s</output> <label>speed <select id=\"speed\">"], ...
                  numel (d.t) - 1, d.t(1)), pace, "</select></label> ", ...
          check_box("traces", "traces of mass centres")];
  if (! isempty (d.arrows))
    text = [text, " ", check_box("forces", "forces")];
  endif
  if (! isempty (d.points))
    names = cellfun (@(p) gs.text.html_escaped (p.name), d.points, "UniformOutput", false);
    text = [text, " ", check_box("points", ["points and frames: " strjoin(names, ", ")])];
  endif
  said = {"</p>", ["<canvas id=\"scene3d\" width=\"960\" height=\"557\" tabindex=\"0\" " ...
                   "aria-label=\"The scene in space; drag or arrow keys turn it, the wheel " ...
                   "zooms\"></canvas>"], ...
          ["<p id=\"no-webgl\" hidden=\"hidden\">This browser has no WebGL: the picture shows " ...
           "one instant.</p>"], ...
          ["<p>A link without a shape (option shape) is drawn as the box of equal mass and " ...
           "inertia, by its edges where that is large; rods lead from its mass centre to its " ...
           "joints. A beam is drawn by its bent axis, a flexible link by modal data by lines " ...
           "between its nodes.</p>"]};
  text = [text, sprintf("%s\n", said{:})];
endfunction

function text = check_box (id, what)
  text = sprintf (["<label><input type=\"checkbox\" id=\"%s\" checked=\"checked\" /> " ...
                   "%s</label>"], id, what);
endfunction
