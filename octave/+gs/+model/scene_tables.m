## [lists, members, of_plan] = gs.model.scene_tables (json, emitted)
## What runs need of the scene of a decoded JSON besides its subroutines, in C: static arrays, the
## members of gs_description (host/start.h) by name, those of gs_scene for the plan of a run.
## EMITTED: the ends of the names of the subroutines.

function [lists, members, of_plan] = scene_tables (json, emitted)
  m = gs.model.read_description (json);
  parameters = gs.given.names_and_units (json.parameters);
  integers = {"sets", m.orientation' - 1
              "speedrows", m.speed_rows
              "settled", numbers(json, "settled") - 1
              "angles", strcmp(m.units.coordinates, "rad")
              "followed", m.internal
              "margin_values", margin_values(json, parameters)};
  [residuals, places] = collocation (json, parameters);
  integers = [integers; places];
  texts = {"states", m.states; "events", {m.events.name}; "devices", {m.controllers.name}
           "margins", m.state_margins; "parameters", parameters};
  if (numel (m.multipliers) == m.sizes.nlam)
    texts(end+1,:) = {"constraints", m.multipliers};
  endif
  list = @(kind, name, text) sprintf ("static const %s about_%s[] = { %s}; ", kind, name, text);
  of_integers = @(row) list ("int", row{1}, sprintf ("%d, ", [row{2}(:)', 0]));
  lists = list ("double", "nominal", sprintf ("%.17g, ", m.nominal));
  members = {".nominal = about_nominal"};
  for row = integers'
    lists = [lists, of_integers(row)];
    members{end+1} = sprintf (".%s = about_%s", row{[1, 1]});
  endfor
  for row = texts'
    lists = [lists, list("char *const", row{1}, [quoted(row{2}), "0 "])];
    members{end+1} = sprintf (".%s = about_%s", row{[1, 1]});
  endfor
  members = [members, {sprintf(".nsets = %d, .nspeedrows = %d, .nsettled = %d, .nmargins = %d", ...
                               rows (m.orientation), numel (m.speed_rows), ...
                               numel (numbers (json, "settled")), numel (m.state_margins)), ...
                       sprintf(".ncst = %d, .npar = %d, .order = %d, .nfollowed = %d", ...
                               m.sizes.ncst, m.sizes.npar, m.order, numel (m.internal)), ...
                       sprintf(".loop_method = %d", ...
                               [find(strcmp (parameters, "loop_method")) - 1, -1](1)), ...
                       sprintf([".nresiduals = %d, .njacobian = %d, .nhessian = %d, " ...
                                ".nunknown = %d"], residuals, columns (places{1,2}), ...
                               columns (places{2,2}), numel (places{3,2}))}];
  for row = {"mar", "rha"; "mar", "audited"}
    if (any (strcmp (emitted, row{1})))
      members{end+1} = sprintf (".%s = run_%s", row{[2, 1]});
    endif
  endfor
  members = strjoin (members, ", ");
  of_plan = {};
  for row = plan_lists (m)'
    lists = [lists, of_integers(row)];
    of_plan{end+1} = sprintf (".%s = about_%s", row{[1, 1]});
  endfor
  of_plan = strjoin ([of_plan, sprintf(".nswitch = %d, .nheld = %d", ...
                                       numel (switches (m.events)), ...
                                       numel (vertcat (m.controllers.outputs)))], ", ");
endfunction

## the arrays of gs_scene for the plan of a run
function list = plan_lists (m)
  [switch_events, switch_inputs] = switches (m.events);
  list = {"event_inputs", [m.events.input]
          "event_kinds", event_kinds(m)
          "switch_events", switch_events
          "switch_inputs", switch_inputs
          "held_counts", cellfun(@numel, {m.controllers.outputs})
          "again", double([m.controllers.again])
          "held_inputs", vertcat(m.controllers.outputs)};
endfunction

function kinds = event_kinds (m)
  kinds = 1 + strcmp ({m.events.kind}, "stop");
  if (isfield (m.events, "ends"))
    own = strcmp ({m.events.kind}, "event");
    kinds(own) = 3 + [m.events(own).ends];
    kinds(own & kinds == 3 & ! gs.events.changing_events (m)) = 5;
  endif
endfunction

## inputs that events of the user switch, and the events
function [events, inputs] = switches (list)
  events = inputs = [];
  if (isfield (list, "ends"))
    for k = find (strcmp ({list.kind}, "event"))
      inputs = [inputs, list(k).switches(:)'];
      events(end+1:numel (inputs)) = k;
    endfor
  endif
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
