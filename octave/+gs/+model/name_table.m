## t = gs.model.name_table (m)
## What the numbers of a model's results are, a struct array: name (none twice), unit, kind (state,
## input, output, point, effort, multiplier, margin), meaning, and where they stand: field of the
## result and column.

function t = name_table (m)
  persistent made = struct ();   # of the models in use: each run of a model asks for it
  key = "";
  if (isfield (m, "symbol"))
    key = [m.symbol, sprintf(" %s", m.states{:}, m.inputs{:}, m.outputs{:}, m.multipliers{:}, ...
                             m.margins{:}), sprintf(" %d", m.actuated)];
  endif
  if (isfield (made, key))
    t = made.(key);
    return;
  endif
  t = table_of (m);
  if (! isempty (key))
    if (numfields (made) >= 20)
      made = struct ();
    endif
    made.(key) = t;
  endif
endfunction

function t = table_of (m)
  t = struct ("name", {}, "unit", {}, "kind", {}, "meaning", {}, "field", {}, "column", {});
  d = m.sizes;
  devices = part (m, "devices");
  joints = part (m, "joints");
  outputs = part (m, "outputs");
  for k = 1:numel (m.states)
    t(end+1) = row (m.states{k}, m.units.states{k}, "state", of_state (m, k, joints, ...
        devices), "x", k);
  endfor
  for k = 1:numel (m.inputs)
    t(end+1) = row (m.inputs{k}, m.units.inputs{k}, "input", of_device ("input", ...
        m.inputs{k}, devices), ...
                    "v", k);
  endfor
  for k = 1:numel (m.outputs)
    text = "output of the scene";
    if (k <= numel (outputs) && isfield (outputs{k}, "expression"))
      text = ["output: " outputs{k}.expression];
    endif
    t(end+1) = row (m.outputs{k}, m.units.outputs{k}, "output", text, "y", k);
  endfor
  t = [t, of_points(m)];
  moved = (1:d.nu)';
  if (d.nlam > 0)
    moved = m.actuated;
  endif
  by = {"speeds", "coordinates"}{1 + (d.nlam > 0 || d.nq == d.nu)};
  for k = 1:numel (moved)
    name = m.(by){moved(k)};
    t(end+1) = row (["effort." name], effort_unit (m.units.(by){moved(k)}), "effort", ...
                    ["effort that moves " name], "tau", k);
  endfor
  for k = 1:numel (m.multipliers)
    t(end+1) = row (m.multipliers{k}, m.units.multipliers{k}, "multiplier", ...
                    "multiplier of a constraint", "lambda", k);
  endfor
  for k = 1:numel (m.margins)
    t(end+1) = row (sprintf ("margin%d", k), "", "margin", m.margins{k}, "margins", k);
  endfor
  t = distinct (t);
endfunction

## the places of points and frames that stand on links
function t = of_points (m)
  t = struct ("name", {}, "unit", {}, "kind", {}, "meaning", {}, "field", {}, "column", {});
  if (! (isfield (m, "points") && any (strcmp (m.subroutines, "pnt"))))
    return;
  endif
  for k = find (! strcmp ({m.json.points.link}, "ground"))
    for axis = 1:3
      t(end+1) = row (sprintf ("%s.%s", m.points{k}, "xyz"(axis)), "m", "point", ...
                      sprintf ("place of %s %s, from the origin of ground", ...
                               m.json.points(k).kind, m.points{k}), ...
                      "points", 3 * (k - 1) + axis);
    endfor
  endfor
endfunction

function r = row (name, unit, kind, meaning, field, column)
  r = struct ("name", name, "unit", unit, "kind", kind, "meaning", meaning, "field", field, ...
              "column", column);
endfunction

## a part of the JSON as a cell array of structs, empty where it says nothing
function list = part (m, name)
  list = {};
  if (isfield (m, "json") && isfield (m.json, name) && ! isempty (m.json.(name)))
    list = m.json.(name);
    if (! iscell (list))
      list = num2cell (list(:)');
    endif
  endif
endfunction

function text = of_state (m, k, joints, devices)
  d = m.sizes;
  if (k <= d.nq)
    text = ["coordinate" of_joint(joints, "coordinates", m.states{k})];
  elseif (k <= d.nq + d.nu && d.nq == d.nu)
    text = ["speed of " m.states{k - d.nq}];
  elseif (k <= d.nq + d.nu)
    text = ["speed" of_joint(joints, "speeds", m.states{k})];
  else
    text = of_device ("state", m.states{k}, devices);
  endif
endfunction

function text = of_joint (joints, field, name)
  text = "";
  for j = joints
    if (! isempty (j{1}.(field)) && any (strcmp (cellstr (j{1}.(field)), name)))
      text = sprintf (" of %s %s", j{1}.type, j{1}.name);
    endif
  endfor
endfunction

function text = of_device (kind, name, devices)
  text = [kind " of the scene"];
  owner = strtok (name, ".");
  for a = devices
    if (strcmp (a{1}.name, owner) && any (name == "."))
      text = sprintf ("%s of %s (%s)", kind, owner, a{1}.text);
    endif
  endfor
endfunction

## [J / the coordinate's unit]
function unit = effort_unit (moved)
  unit = {"N*m", "N"}{1 + strncmp(moved, "m", 1)};
endfunction

## a name that is there already has its kind behind it
function t = distinct (t)
  seen = {};
  for k = 1:numel (t)
    if (any (strcmp (seen, t(k).name)))
      t(k).name = [t(k).name " (" t(k).kind ")"];
    endif
    n = 1;
    base = t(k).name;
    while (any (strcmp (seen, t(k).name)))
      t(k).name = sprintf ("%s %d", base, ++n);
    endwhile
    seen{end+1} = t(k).name;
  endfor
endfunction
