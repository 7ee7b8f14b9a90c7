## m = gs.model.read_description (json)
## What the description of a scene says of a model: names and units, sizes, devices, loops, the
## skeleton.

function m = read_description (json)
  m.name = json.name;
  [m.gsmbp_version, m.scene_hash] = origin (json);
  m.sizes = json.dimensions;
  for part = {"coordinates", "speeds", "states", "inputs", "outputs", "multipliers"}
    p = part{1};
    list = [];
    if (isfield (json, p))
      list = json.(p);
    endif
    [m.(p), m.units.(p)] = gs.given.names_and_units (list);
  endfor
  m.subroutines = cellfun (@(s) tolower (s(numel (json.name)+2:end)), ...
                           gs.given.names_and_units (json.subroutines), "UniformOutput", false);
  m.order = json.command_order;
  m.actuated = double (json.actuated(:));
  m.nominal = nominal (json);
  m.internal = zeros (0, 1);
  m.margins = cell (0, 1);
  if (isfield (json, "internal") && ! isempty (json.internal))
    m.internal = double (json.internal(:));
  endif
  if (isfield (json, "margins") && ! isempty (json.margins))
    m.margins = cellstr (json.margins)(:);
  endif
  m.static_margins = cell (0, 1);
  if (isfield (json, "static_margins") && ! isempty (json.static_margins))
    m.static_margins = cellstr (json.static_margins)(:);
  endif
  m.state_margins = cell (0, 1);
  if (isfield (json, "state_margins") && ! isempty (json.state_margins))
    m.state_margins = cellstr (json.state_margins)(:);
  endif
  m.controllers = controllers (json);
  m.input_starts = zeros (json.dimensions.nv, 1);
  if (isfield (json, "input_starts"))
    m.input_starts = double (json.input_starts(:));
  endif
  m.events = struct ("name", {}, "entry", {}, "kind", {}, "input", {});
  if (isfield (json, "events") && ! isempty (json.events))
    m.events = json.events(:)';
  endif
  m.points = cell (0, 1);
  if (isfield (json, "points") && ! isempty (json.points))
    m.points = gs.given.names_and_units (json.points);
  endif
  m.skeleton = gs.model.scene_skeleton (json);
  m = loops (m, json);
endfunction

## the version of GSMBP that emitted the scene and the hash of the scene, "" where the JSON (one
## written by hand) says nothing
function [number, scene] = origin (json)
  number = scene = "";
  if (isfield (json, "gsmbp_version"))
    number = json.gsmbp_version;
  endif
  if (isfield (json, "scene_hash"))
    scene = json.scene_hash;
  endif
endfunction

## the usual sizes of the states, 1 where the JSON says nothing
function sizes = nominal (json)
  sizes = ones (json.dimensions.nx, 1);
  if (isfield (json, "nominal") && numel (json.nominal) == numel (sizes))
    sizes = double (json.nominal(:));
    sizes(! (sizes > 0)) = 1;
  endif
endfunction

## what the JSON says of loops and orientations, empty where it says nothing
function m = loops (m, json)
  m.removed = m.mobility = struct ([]);
  m.orientation = gs.model.orientation_sets (json);
  m.angles = cell (0, 1);
  m.speed_rows = zeros (0, 1);
  if (isfield (json, "removed") && ! isempty (json.removed))
    m.removed = json.removed;
  endif
  if (isfield (json, "mobility"))
    m.mobility = json.mobility;
  endif
  if (isfield (json, "angles"))
    m.angles = gs.given.names_and_units (json.angles);
  endif
  if (isfield (json, "speed_rows"))
    m.speed_rows = double (json.speed_rows(:));
  endif
endfunction

## the sampled devices, a struct array
function list = controllers (json)
  list = struct ("name", {}, "entry", {}, "period", {}, "delay", {}, "memory", {}, "starts", {}, ...
                 "outputs", {}, "reads", {}, "again", {}, "rounds", {});
  if (isfield (json, "controllers") && ! isempty (json.controllers))
    list = json.controllers(:)';
    for k = 1:numel (list)
      list(k).memory = gs.given.names_and_units (list(k).memory);   # variant p has none
      for name = {"starts", "outputs", "reads"}
        list(k).(name{1}) = double (list(k).(name{1})(:));
      endfor
    endfor
  endif
endfunction
