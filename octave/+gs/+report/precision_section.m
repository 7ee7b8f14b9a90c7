## text = gs.report.precision_section (who, w)
## Speed against error: a figure and a table of the result W of gsmbp_workprecision; nothing of [].

function text = precision_section (who, w)
  text = "";
  if (isempty (w))
    return;
  endif
  needed = {"method", "step", "calls", "seconds", "error", "error_states"};
  if (! (isstruct (w) && all (isfield (w, needed))))
    error ("%s: option workprecision: expected a result of gsmbp_workprecision, found %s", who,
           gs.text.shown_value (w));
  endif
  methods = unique ({w.method}, "stable");
  most = max (cellfun (@(name) sum (strcmp ({w.method}, name)), methods));
  [x, y] = deal (NaN (most, numel (methods)));
  for k = 1:numel (methods)
    own = find (strcmp ({w.method}, methods{k}));
    x(1:numel (own),k) = [w(own).error];
    y(1:numel (own),k) = 1e6 * [w(own).seconds];
  endfor
  cells = arrayfun (@(one) {one.method, sprintf("%g", one.step), sprintf("%d", one.calls), ...
                            sprintf("%.2f", 1e6 * one.seconds), sprintf("%.2e", one.error), ...
                            sprintf("%.2e", one.error_states)}, w(:), "UniformOutput", false);
  text = [sprintf("<h2>Speed against error</h2>\n"), ...
          gs.text.svg_plot("Speed against error", x, y, methods, ...
                           {"largest error of a coordinate", ...
                            "computing time [microseconds per second]"}, "log"), ...
          gs.text.html_table({"method", "step or tolerance", "calls", "microseconds/second", ...
                              "error of coordinates", "error of states"}, vertcat (cells{:}))];
endfunction
