## text = gs.machine.page_figures (d)
## The figures of a design D: torque and speed of each drive, the loop, tracking and voltages of
## the machine, nominally and at the corners.

function text = page_figures (d)
  text = sprintf ("<h2>Figures</h2>\n");
  for j = 1:numel (d.axes)
    pair = d.drives(j).pairs(d.chosen(j)).name;
    text = [text, picture(["The load cycle of " d.axes(j).coordinate ...
                           " in the torque-speed plane of " pair], ...
                          @(file) gsmbp_drive_plot (file, d.drives(j), "plane", pair))];
  endfor
  text = [text, picture("The loop: linear model, and the machine beside it in the first task", ...
                        @(file) gsmbp_loop (d.controller, file, d.machine, d.proof.runs{1}))];
  for i = 1:numel (d.tasks)
    text = [text, tracking(d, i), voltages(d, i)];
  endfor
endfunction

## drawn by gnuplot, as data within the page
function text = picture (title, draw)
  file = [tempname() ".png"];
  guard = onCleanup (@() cellfun (@gs.files.discard_file, {file, [file(1:end-4) ".csv"]}));
  draw (file);
  f = fopen (file, "r");
  bytes = fread (f, Inf, "uint8=>uint8");
  fclose (f);
  text = sprintf (["<div class=\"picture\"><p>%s</p>\n<img alt=\"%s\" " ...
                   "style=\"max-width:100%%\" src=\"data:image/png;base64,%s\" /></div>\n"], ...
                  gs.text.html_escaped (title), gs.text.html_escaped (title), ...
                      matlab.net.base64encode (bytes'));
endfunction

## errors of each axis: nominal, and at the corner that is worst for it
function text = tracking (d, i)
  text = "";
  for j = 1:numel (d.axes)
    a = d.axes(j);
    r = d.proof.runs{i};
    [y, names] = deal (r.error(:,j), {"nominal"});
    one = d.margins(strcmp ({d.margins.axis}, a.coordinate) ...
                    & strcmp ({d.margins.name}, "tracking error"));
    if (! isempty (one.corner))
      q = d.corners(one.corner).proof.runs{i}.error(:,j);
      y(:,2) = NaN;
      y(1:numel (q),2) = q;
      names{2} = ["corner " gs.proof.corner_text(d.asked, d.corners(one.corner).signs)];
    endif
    said = sprintf ("Tracking error of %s, %s; allowed: %.4g %s", a.coordinate, ...
                    d.tasks(i).name, d.asked.accuracy(j), a.unit);
    if (max (abs (y(:))) > d.asked.accuracy(j) / 4)
      y = [y, repmat([1, -1] * d.asked.accuracy(j), rows (y), 1)];
      names = [names, {"allowed", "allowed"}];
    endif
    text = [text, sprintf("<p>%s</p>\n", gs.text.html_escaped (said)), ...
            gs.text.svg_plot(said, r.t(1:rows (y)), y, names, ...
                                  {"time [s]", sprintf("error of %s [%s]", a.coordinate, a.unit)})];
  endfor
endfunction

function text = voltages (d, i)
  r = d.proof.runs{i};
  v = r.v(:,[d.axes.input]);
  said = ["Voltages, " d.tasks(i).name];
  text = [sprintf("<p>%s</p>\n", gs.text.html_escaped (said)), ...
          gs.text.svg_plot(said, r.t, v, strcat ({d.axes.motor}, ".v"), ...
                           {"time [s]", "voltage [V]"})];
endfunction
