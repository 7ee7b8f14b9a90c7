## text = gs.report.run_figures (m, r)
## The figures of a run over time: coordinates, speeds, states of devices, inputs, outputs, each by
## unit, at most eight lines in a figure.

function text = run_figures (m, r)
  nq = m.sizes.nq;
  nm = nq + m.sizes.nu;
  x = r.x;
  text = [group("Coordinates", r.t, x(:,1:nq), m.coordinates, m.units.coordinates), ...
          group("Speeds", r.t, x(:,nq+1:nm), m.speeds, m.units.speeds), ...
          group("States of devices", r.t, x(:,nm+1:end), m.states(nm+1:end), ...
                m.units.states(nm+1:end))];
  if (isfield (r, "v") && ! isempty (r.v) && columns (r.v) == numel (m.inputs))
    text = [text, group("Inputs", r.t, r.v, m.inputs, m.units.inputs)];
  endif
  if (! isempty (m.outputs))
    text = [text, group("Outputs", r.t, outputs_of (m, r), m.outputs, m.units.outputs)];
  endif
endfunction

## the outputs at all instants; those of the run where it has them
function y = outputs_of (m, r)
  y = zeros (numel (r.t), 0);
  if (isfield (r, "y") && rows (r.y) == numel (r.t))
    y = r.y;
  elseif (any (strcmp (m.subroutines, "out")) && isfield (r, "v"))
    y = gs.run.output_values (m, gs.run.row_times (m, r.t), r.x, r.v);
  endif
endfunction

## a section: a figure for each unit
function text = group (title, t, y, names, units)
  text = "";
  if (isempty (y))
    return;
  endif
  kinds = unique (units(:)', "stable");
  for k = 1:numel (kinds)
    lines = find (strcmp (units(:)', kinds{k}));
    most = ceil (numel (lines) / ceil (numel (lines) / 8));
    for first = 1:most:numel (lines)
      few = lines(first:min (first + most - 1, end));
      text = [text, figure_of(title, t, y(:,few), names(few), kinds{k})];
    endfor
  endfor
  text = [sprintf("<h2>%s</h2>\n", title), text];
endfunction

function text = figure_of (title, t, y, names, unit)
  few = unique (round (linspace (1, numel (t), min (numel (t), 600))));
  quantity = title;
  if (numel (names) == 1)
    quantity = names{1};
  endif
  if (! (isempty (unit) || strcmp (unit, "1")))
    quantity = sprintf ("%s [%s]", quantity, unit);
  endif
  text = gs.text.svg_plot (sprintf ("%s: %s", title, strjoin (names(:)', ", ")), t(:)(few), ...
                           y(few,:), names(:)', {"time [s]", quantity});
endfunction
