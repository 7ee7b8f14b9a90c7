## [lists, members] = gs.model.start_tables (json, emitted)
## What the start of a run needs of the scene of a decoded JSON (gs_description of host/start.h) in
## C: static arrays, and its members by name.  EMITTED: the ends of the names of the subroutines.

function [lists, members] = start_tables (json, emitted)
  m = gs.model.read_description (json);
  parameters = gs.given.names_and_units (json.parameters);
  integers = {"sets", m.orientation' - 1
              "speedrows", m.speed_rows
              "settled", numbers(json, "settled") - 1
              "angles", strcmp(m.units.coordinates, "rad")
              "margin_values", margin_values(json, parameters)};
  [residuals, places] = collocation (json, parameters);
  integers = [integers; places];
  texts = {"states", m.states; "events", {m.events.name}; "devices", {m.controllers.name}
           "margins", m.state_margins; "parameters", parameters};
  if (numel (m.multipliers) == m.sizes.nlam)
    texts(end+1,:) = {"constraints", m.multipliers};
  endif
  list = @(kind, name, text) sprintf ("static const %s about_%s[] = { %s}; ", kind, name, text);
  lists = list ("double", "nominal", sprintf ("%.17g, ", m.nominal));
  members = {".nominal = about_nominal"};
  for row = integers'
    lists = [lists, list("int", row{1}, sprintf ("%d, ", [row{2}(:)', 0]))];
    members{end+1} = sprintf (".%s = about_%s", row{[1, 1]});
  endfor
  for row = texts'
    lists = [lists, list("char *const", row{1}, [quoted(row{2}), "0 "])];
    members{end+1} = sprintf (".%s = about_%s", row{[1, 1]});
  endfor
  members = [members, {sprintf(".nsets = %d, .nspeedrows = %d, .nsettled = %d, .nmargins = %d", ...
                               rows (m.orientation), numel (m.speed_rows), ...
                               numel (numbers (json, "settled")), numel (m.state_margins))}];
  members{end+1} = sprintf (".nresiduals = %d, .njacobian = %d, .nhessian = %d, .nunknown = %d", ...
                            residuals, columns (places{1,2}), columns (places{2,2}), ...
                            numel (places{3,2}));
  if (any (strcmp (emitted, "mar")))
    members{end+1} = ".mar = run_mar";
  endif
  members = strjoin (members, ", ");
endfunction

function list = numbers (json, name)
  list = [];
  if (isfield (json, name))
    list = double (json.(name)(:));
  endif
endfunction

## of each margin how many states its message shows, these, how many parameters, these
function list = margin_values (json, parameters)
  list = [];
  for row = gs.model.json_rows (json, "margin_values")
    states = double (row{1}.states(:))';
    own = {};
    if (! isempty (row{1}.parameters))
      own = cellstr (row{1}.parameters)(:)';
    endif
    [~, places] = ismember (own, parameters);
    list = [list, numel(states), states - 1, numel(own), places(:)' - 1];
  endfor
endfunction

## where the entries of DAJ and DAH are, the parameters among their unknowns
function [residuals, places] = collocation (json, parameters)
  residuals = 0;
  places = {"jacobian", zeros(2, 0); "hessian", zeros(2, 0); "unknown", []};
  if (isfield (json, "collocation"))
    s = json.collocation;
    residuals = s.residuals;
    places{1,2} = reshape (s.jacobian, [], 2)' - 1;   # [] where a scene has none
    places{2,2} = reshape (s.hessian, [], 2)' - 1;
    if (! isempty (s.parameters))
      [~, k] = ismember (cellstr (s.parameters), parameters);
      places{3,2} = k - 1;
    endif
  endif
endfunction

## constants of C, one after the other
function text = quoted (list)
  list = cellfun (@(text) ["\"" strrep(undo_string_escapes (text), "?", "\\?") "\", "], ...
                  list(:)', "UniformOutput", false);
  text = [list{:}, ""];
endfunction
