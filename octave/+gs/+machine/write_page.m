## gs.machine.write_page (who, d, file)
## The page of the design D: the verdict, what was asked, every decision with its reason, figures,
## the margins under tolerances, what would have to change to get more, parameters.

function write_page (who, d, file)
  [head, foot] = gs.text.html_page (["Design of " d.model.name]);
  parts = {verdict(d), asked(d), chosen(d)};
  if (d.found)
    parts = [parts, {gs.machine.page_figures(d), margins(d), yields(d)}];
  endif
  parts = [parts, {more(d), parameters(d), limits_of(d)}];
  gs.files.write_text (who, make_absolute_filename (file), [head, parts{:}, foot]);
endfunction

function text = verdict (d)
  if (isempty (d.unmet))
    said = ["All demands are met, nominally and at the corners of the tolerances that were " ...
            "run; Ms is demanded of the nominal machine alone."];
    if (d.asked.Ms_corners)
      said = strrep (said, "of the nominal machine alone", "at all corners of the tolerances");
    endif
    if (isempty (d.asked.tolerances))
      said = "All demands are met at the nominal values; no tolerances were given.";
    endif
    text = sprintf ("<p><strong>%s</strong></p>\n", said);
  else
    text = [sprintf("<p><strong>Not met:</strong></p>\n"), list_of({d.unmet.said})];
  endif
endfunction

function text = list_of (sentences)
  items = cellfun (@(s) sprintf ("<li>%s</li>\n", gs.text.html_escaped (s)), sentences(:)', ...
                   "UniformOutput", false);
  text = [sprintf("<ul>\n"), items{:}, sprintf("</ul>\n")];
endfunction

function text = asked (d)
  s = d.asked;
  number = @(x) strjoin (arrayfun (@(v) sprintf ("%.5g", v), x, "UniformOutput", false), ", ");
  cells = {"axes", strjoin(arrayfun (@(a) sprintf ("%s (motor %s, gear %s, measured %s)", ...
                                                   a.coordinate, a.motor, ...
                                                   [a.gear "none"(1:4 * isempty (a.gear))], ...
                                                   a.output), d.axes, "UniformOutput", false), ...
                           "; ")
           "motions", strjoin(arrayfun (@task, d.tasks, "UniformOutput", false), "; ")
           "accuracy", [number(s.accuracy) " (largest tracking error of each axis)"]
           "supply", sprintf("%g V, %g A", s.supply, s.current)
           "catalogue", sprintf("%d motors, %d gears, %d screws", numel (s.motors), ...
                               numel (s.gears), numel (s.screws))
           "best by", s.goal
           "reserve of the drives", sprintf("%g %%", 100 * s.reserve)
           "largest load : motor inertia", number(s.inertia_ratio)
           "sampling", sprintf("every %g ms, delay %g ms, steps of the encoders %g", ...
                               1e3 * s.period, 1e3 * s.delay, s.encoder)
           "largest sensitivity Ms", number(s.Ms)
           "springs", strjoin(cellfun (@(n, x) sprintf ("%s from %.4g to %.4g", n, x), ...
                                       s.springs(:,1), s.springs(:,2), "UniformOutput", ...
                                       false)', ", ")
           "tolerances", strjoin(cellfun (@(n, x) sprintf ("%s %.4g %%", n, 100 * x), ...
                                          s.tolerances(:,1), s.tolerances(:,2), ...
                                          "UniformOutput", false)', ", ")};
  text = [sprintf("<h2>What is asked</h2>\n"), gs.text.html_table({"demand", "value"}, cells)];
endfunction

function text = task (t)
  text = sprintf ("%s, %.5g s to %.5g s", t.name, t.start, t.stop);
  for name = fieldnames (t.values)'
    text = sprintf ("%s, %s = %.5g", text, name{1}, t.values.(name{1}));
  endfor
endfunction

function text = chosen (d)
  text = sprintf ("<h2>Decisions</h2>\n");
  for one = d.decisions
    text = [text, sprintf("<h3>%s</h3>\n", gs.text.html_escaped ([one.what ": " one.chosen])), ...
            list_of(one.why)];
    if (! isempty (one.alternatives))
      text = [text, sprintf("<p>Instead:</p>\n"), list_of(one.alternatives)];
    endif
  endfor
endfunction

## how many machines within the tolerances keep their limits
function text = yields (d)
  text = "";
  y = d.yield;
  if (isempty (y))
    return;
  endif
  said = sprintf (["%d of %d machines with parameters by chance within the tolerances keep all " ...
                   "limits: a yield of %.1f %%, 95 %% interval %.1f to %.1f %%."], ...
                  y.met, y.runs, 100 * y.share, 100 * y.between);
  cells = cell (0, 4);
  for one = y.measures
    cells(end+1,:) = {one.axis, one.name, sprintf("%.1f %%", 100 * one.share), ...
                      sprintf("%.0f %%", 100 * one.worst)};
  endfor
  text = [sprintf("<h2>Yield</h2>\n<p>%s</p>\n", gs.text.html_escaped (said)), ...
          gs.text.html_table({"axis", "quantity", "keep their limit", "most that is used"}, cells)];
endfunction

function text = margins (d)
  heads = {"axis", "quantity", "allowed", "nominal", "used", "to first order", "worst found", ...
           "used", "at the corner"};
  cells = cell (0, numel (heads));
  for one = d.margins
    row = {one.axis, sprintf("%s [%s]", one.name, one.unit), sprintf("%.4g", one.limit), ...
           sprintf("%.4g", one.found), sprintf("%.0f %%", 100 * one.used), "", "", "", ""};
    if (! isempty (one.worst))
      row(6:9) = {sprintf("%.4g", one.first), sprintf("%.4g", one.worst), ...
                  sprintf("%.0f %%", 100 * one.worst / one.limit), ...
                  gs.proof.corner_text(d.asked, d.corners(one.corner).signs)};
    endif
    cells(end+1,:) = row;
  endfor
  n = rows (d.asked.tolerances);
  said = "No tolerances were given.";
  if (n > 0)
    which_ = "";
    if (numel (d.corners) < 2 ^ n)
      which_ = ": those that the derivatives of each quantity call its worst";
    endif
    said = sprintf (["The machine was run at %d of the %d corners of the tolerances%s. To " ...
                     "first order: nominal value and derivatives times tolerances, at the time " ...
                     "where this is largest; the derivatives are %s."], ...
                    numel (d.corners), 2 ^ n, ...
                    which_, d.derivatives);
  endif
  text = [sprintf("<h2>Margins</h2>\n<p>%s</p>\n", gs.text.html_escaped (said)), ...
          gs.text.html_table(heads, cells)];
endfunction

function text = more (d)
  text = sprintf ("<h2>What would have to change</h2>\n");
  if (isempty (d.more))
    text = [text, sprintf("<p>Nothing was found.</p>\n")];
  else
    text = [text, list_of({d.more.said})];
  endif
endfunction

function text = parameters (d)
  text = "";
  if (! d.found)
    return;
  endif
  names = fieldnames (d.model.par);
  values = cellfun (@(n) sprintf ("%.6g", d.model.par.(n)), names, "UniformOutput", false);
  cells = [names, values, d.model.units.parameters(:)];
  text = [sprintf("<h2>Parameters of the machine</h2>\n"), ...
          gs.text.html_table({"parameter", "value", "unit"}, cells)];
endfunction

## what nobody looked at
function text = limits_of (d)
  text = [sprintf("<h2>What was not looked at</h2>\n"), list_of(d.notes)];
endfunction
