## text = gs.report.page_tables (m, r)
## What else a run says: energy audit, margins, figures of the integration.

function text = page_tables (m, r)
  text = "";
  if (isfield (r, "audit") && ! isempty (r.audit.balance))
    text = [text, audit_of(r)];
  endif
  if (! isfield (r, "stats"))
    return;
  endif
  if (isfield (r.stats, "margins"))
    text = [text, margins_of(m, r.stats.margins)];
  endif
  text = [text, sprintf("<h2>Integration</h2>\n"), gs.text.html_table({"figure", "value"}, ...
                                                                    rows_of ("", r.stats))];
endfunction

function text = audit_of (r)
  text = [sprintf("<h2>Energy audit</h2>\n"), ...
          sprintf(["<p>Largest imbalance beside what passed, what is stored and the swing of " ...
                   "the kinetic energy: %.3g.</p>\n"], r.audit.error), ...
          gs.text.svg_plot("Energy less what came in and was lost", r.t(:), r.audit.balance(:), ...
                           {"balance"}, {"time [s]", "balance [J]"}), ...
          gs.text.svg_plot("Energy that passed", r.t(:), r.audit.passed(:), {"passed"}, ...
                           {"time [s]", "passed [J]"})];
endfunction

function text = margins_of (m, list)
  if (isempty (m.state_margins))
    text = "";
  elseif (isempty (list))
    text = sprintf ("<h2>Margins</h2>\n<p>All kept at the instants of the run: %s.</p>\n", ...
                    gs.text.html_escaped (strjoin (m.state_margins(:)', "; ")));
  else
    cells = arrayfun (@(one) {one.text, sprintf("%.6g", one.time), sprintf("%.6g", one.least), ...
                              one.said}, list(:), "UniformOutput", false);
    text = [sprintf("<h2>Margins that were not kept</h2>\n"), ...
            gs.text.html_table({"margin", "first time [s]", "least", "what it is made of"}, ...
                               vertcat (cells{:}))];
  endif
endfunction

## rows {name, value} of the fields that are numbers or words; of a struct, name.field
function list = rows_of (prefix, s)
  list = cell (0, 2);
  for name = fieldnames (s)'
    v = s.(name{1});
    if (isstruct (v) && isscalar (v))
      list = [list; rows_of([prefix name{1} "."], v)];
    elseif ((isnumeric (v) || islogical (v)) && numel (v) >= 1 && numel (v) <= 4)
      list(end+1,:) = {[prefix name{1}], strtrim(sprintf ("%.6g ", v))};
    elseif (ischar (v) && ! isempty (v))
      list(end+1,:) = {[prefix name{1}], v};
    endif
  endfor
endfunction
