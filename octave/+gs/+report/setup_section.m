## text = gs.report.setup_section (m, r)
## How a run was made: its options, what its inputs were, the planned motion beside the run's, the
## gain of a feedback, its reference and limits; sampled devices; the parameters.

function text = setup_section (m, r)
  text = "";
  if (isfield (r, "options") && isstruct (r.options))
    o = r.options;
    text = [options_of(m, r, o), inputs_of(m, r, o), plan_of(m, r, o), feedback_of(m, r, o)];
  endif
  text = [text, samplers_of(m), parameters_of(m)];
endfunction

## those that were given, and the method and its tolerances as they were used
function text = options_of (m, r, o)
  cells = cell (0, 2);
  for name = fieldnames (o)'
    if (! any (strcmp (name{1}, {"input", "motion", "gain", "reference", "limits", "rtol", ...
                                 "atol", "method"})))
      cells(end+1,:) = {name{1}, gs.text.shown_value(o.(name{1}))};
    endif
  endfor
  if (isfield (r, "stats") && isfield (r.stats, "method"))
    cells = [{"method", r.stats.method}; tolerances(r.stats); cells];
  endif
  if (m.sizes.nlam > 0 && ! any (isfield (o, {"loops", "projection"})))
    cells(end+1,:) = {"loops", "projection (default)"};
  endif
  text = [sprintf("<h2>How it was run</h2>\n"), gs.text.html_table({"option", "value"}, cells)];
endfunction

function cells = tolerances (s)
  cells = {"step [s]", sprintf("%.6g", s.largest_step)};
  if (! strcmp (s.method, "rk4"))
    cells = {"rtol", sprintf("%.3g", s.rtol); ...
             "atol", strjoin(arrayfun (@(a) sprintf ("%.3g", a), s.atol(:)', "UniformOutput", ...
                                       false), ", ")};
  endif
endfunction

function text = inputs_of (m, r, o)
  text = "";
  if (m.sizes.nv == 0 || isfield (o, "motion"))
    return;
  endif
  if (! isfield (o, "input") || isempty (o.input))
    said = "Nothing was given: zero";
  elseif (isstruct (o.input))
    said = ["A piecewise polynomial: " pieces(o.input)];
  elseif (is_function_handle (o.input))
    said = ["A function: " func2str(o.input)];
  elseif (ischar (o.input))
    said = "SUBROUTINE GSVIN of the user";
  else
    said = ["Constant: " listed(inputs_for (m, numel (o.input)), o.input)];
  endif
  text = paragraph ("Inputs from outside", said);
endfunction

## the inputs that numbers are given for: all, or those that no sampled device and no mode holds
function names = inputs_for (m, n)
  names = m.inputs;
  if (n < numel (names))
    names = names(setdiff (1:numel (names), [vertcat(m.controllers.outputs); ...
                                             vertcat(m.events.input)]));
  endif
endfunction

function text = plan_of (m, r, o)
  text = "";
  if (! isfield (o, "motion") || isempty (o.motion))
    return;
  endif
  [pp, planned] = gs.given.given_motion ("gsmbp_report", m, o.motion);
  text = paragraph ("Planned motion", ["The inputs follow from it by the inverse model: " ...
                                       pieces(pp)]);
  f = gsmbp_evaluate (pp, r.t);
  units = m.units.coordinates(planned);
  for k = 1:numel (planned)
    name = m.coordinates{planned(k)};
    text = [text, gs.text.svg_plot(["Planned motion: " name], r.t(:), ...
                                   [f(k,:,1)(:), r.x(:,planned(k))], ...
                                   {["planned " name], ["run: " name]}, ...
                                   {"time [s]", sprintf("%s [%s]", name, units{k})})];
  endfor
endfunction

function text = feedback_of (m, r, o)
  text = "";
  if (! isfield (o, "gain") || isempty (o.gain))
    return;
  endif
  text = [paragraph("State feedback", "v = v0(t) - K(t)*(x - x0(t)), with K in SI units"), ...
          gain_table(m, r, o.gain)];
  x0 = at_start (o.reference, r);
  text = [text, paragraph("", ["Reference x0: " changing(o.reference) ...
                               listed(m.states, x0)])];
  if (isfield (o, "limits") && ! isempty (o.limits))
    text = [text, paragraph("", ["Limits of the inputs: " mat2str(double (o.limits), 6)])];
  endif
endfunction

function text = gain_table (m, r, gain)
  K = reshape (at_start (gain, r), m.sizes.nv, m.sizes.nx);
  cells = [m.inputs(:), arrayfun(@(k) sprintf ("%.6g", k), K, "UniformOutput", false)];
  text = gs.text.html_table (["K", m.states(:)'], cells);
  if (isstruct (gain))
    text = [paragraph("", ["At the start; K is a piecewise polynomial: " pieces(gain)]), text];
  endif
endfunction

function v = at_start (given, r)
  if (isstruct (given))
    v = gsmbp_evaluate (given, r.t(1))(:);
  else
    v = double (given(:));
  endif
endfunction

function text = changing (given)
  text = "";
  if (isstruct (given))
    text = ["a piecewise polynomial, " pieces(given) ", at the start "];
  endif
endfunction

## what acts in samples
function text = samplers_of (m)
  text = "";
  cells = cell (0, 3);
  for c = m.controllers(:)'
    cells(end+1,:) = {c.name, strjoin(m.inputs(c.outputs)', ", "), ...
                      strjoin(m.outputs(c.reads)', ", ")};
  endfor
  if (! isempty (cells))
    text = [sprintf("<h2>Sampled devices</h2>\n"), ...
            gs.text.html_table({"device", "holds", "reads"}, cells)];
  endif
endfunction

function text = parameters_of (m)
  text = "";
  names = fieldnames (m.par);
  if (! isempty (names))
    values = cellfun (@(n) sprintf ("%.6g", m.par.(n)), names, "UniformOutput", false);
    units = repmat ({""}, numel (names), 1);
    if (isfield (m.units, "parameters") && numel (m.units.parameters) == numel (names))
      units = m.units.parameters(:);
    endif
    text = [sprintf("<h2>Parameters of the run</h2>\n"), ...
            gs.text.html_table({"parameter", "value", "unit"}, [names(:), values(:), units])];
  endif
endfunction

function text = pieces (pp)
  text = sprintf ("%d piece%s of degree %d from %.6g s to %.6g s", pp.pieces, ...
                  repmat ("s", 1, pp.pieces > 1), pp.order - 1, pp.breaks(1), pp.breaks(end));
endfunction

function text = listed (names, values)
  text = strjoin (arrayfun (@(k) sprintf ("%s = %.6g", names{k}, values(k)), ...
                            1:min (numel (names), numel (values)), "UniformOutput", false), ", ");
endfunction

function text = paragraph (head, said)
  text = sprintf ("<p>%s.</p>\n", gs.text.html_escaped (said));
  if (! isempty (head))
    text = [sprintf("<h2>%s</h2>\n", head), text];
  endif
endfunction
