## [json, source, text] = gs.model.with_controller (json, text, list, folder)
## The scene of the description JSON and of the Fortran TEXT with the controllers LIST (a struct or
## a cell array of them) as further sampled devices: its description, its Fortran as a file SOURCE
## below FOLDER, and TEXT itself.

function [json, source, text] = with_controller (json, text, list, folder)
  who = "gsmbp_build";
  if (! iscell (list))
    list = {list};
  endif
  own = numel (gs.model.json_rows (json, "controllers"));
  name = upper (json.name);
  text = renamed (text, name, own);
  parts = cell (1, numel (list));
  held = [];
  if (own > 0)
    held = cellfun (@(row) row.outputs(:)', gs.model.json_rows (json, "controllers"), ...
                    "UniformOutput", false);
    held = [held{:}];
  endif
  all_ = json;
  for k = 1:numel (list)
    if (! (isstruct (list{k}) && isfield (list{k}, "cst")))
      gs.controller.check_controller (who, list{k});
    endif
    [json, parts{k}, held] = joined (who, json, list{k}, name, k, held);
  endfor
  text = [text, sprintf("%s", parts{:}), entry(json, all_, list, name)];
  json.subroutines = subroutines (json, name);
  if (own == 0 && any (strcmp (full_names (json), [name "_RHP"])) ...
      && ! any (cellfun (@(c) isfield (c, "schedule") || isfield (c, "cst"), list)))
    text = [text, slopes(json, all_, list, name)];
    json.subroutines{end+1} = struct ("name", [name "_CTD"]);
  endif
  gs.files.make_folder (who, folder);
  source = fullfile (folder, [json.name ".f"]);
  gs.files.write_text (who, source, text);
  gs.files.write_text (who, [source(1:end-2) ".json"], jsonencode (json));
endfunction

## what the scene has of its own makes room for the new entry
function text = renamed (text, name, own)
  if (own > 0)
    text = regexprep (text, ['\<' name '_CTL\>'], [name "_CTO"]);
    text = regexprep (text, ['\<' name '_CTP\>'], [name "_CTQ"]);
  endif
endfunction

## the description with one controller more, and the Fortran that takes its numbers from the scene
function [json, text, held] = joined (who, json, c, name, k, held)
  inputs = gs.given.names_and_units (json.inputs);
  outputs = {};
  if (isfield (json, "outputs") && ! isempty (json.outputs))
    outputs = gs.given.names_and_units (json.outputs);
  endif
  reads = places (who, c, "measured", c.measured, outputs, ...
                  "output of the scene: add output(name, expression)");
  drives = places (who, c, "driven", c.driven, inputs, "input of the scene");
  if (any (ismember (drives, held)))
    error ("%s: the controller %s: the input %s has another device that holds it", who, c.name,
           inputs{drives(find (ismember (drives, held), 1))});
  endif
  held = [held, drives];
  nv = json.dimensions.nv;
  nz = rows (c.A);
  nr = numel (c.references);
  json.dimensions.nv += nr;
  json.dimensions.nxk += nz;
  json.dimensions.nctl += 1;
  [~, units] = gs.given.names_and_units (json.outputs);
  json.inputs = gs.model.json_rows (json, "inputs");
  for i = 1:nr
    json.inputs{end+1} = struct ("name", [c.name "." c.references{i}], "unit", ...
                                 unit_of (c, i, units(reads)));
  endfor
  memory = arrayfun (@(i) sprintf ("%s.z%d", c.name, i), (1:nz)', "UniformOutput", false);
  if (isfield (c, "through"))
    memory{end} = [c.name ".held_samples"];
  endif
  one = struct ("name", c.name, "entry", c.method, "period", c.period, "delay", c.delay, ...
                "memory", {memory}, ...
                "starts", starts (c), "outputs", drives(:), "reads", reads(:), ...
                "again", json.dimensions.nctl > 1, ...
                "rounds", rounds (c), "possible", []);
  before = gs.model.json_rows (json, "controllers");
  before = [before{:}];
  json.controllers = [before, one];
  if (! isfield (json, "input_starts"))
    json.input_starts = zeros (nv, 1);
  endif
  json.input_starts(drives) = c.u0;
  json.input_starts = [json.input_starts; c.r0(:)];
  if (isfield (c, "through"))
    text = gs.controller.drive_text (c, name, k, reads, drives, json.dimensions, nv);
  elseif (isfield (c, "cst"))
    text = gs.controller.model_text (c, name, k, reads, drives, nv);
  else
    text = [gs.controller.text_in_fortran(c, sprintf ("%s_CN%d", name, k)), ...
            connection(c, name, k, reads, drives, nv)];
  endif
endfunction

## what the memory starts with: zeros, at the trim, but for what a controller says itself
function z = starts (c)
  z = zeros (rows (c.A), 1);
  if (isfield (c, "starts"))
    z = c.starts;
  endif
endfunction

## whether converters round; a controller of gsmbp_model_control has none
function yes = rounds (c)
  yes = isfield (c, "step_in") && any ([c.step_in(:); c.step_out(:)] > 0);
endfunction

## of the measurement that follows it, or as the controller says
function unit = unit_of (c, i, units)
  if (isfield (c, "units"))
    unit = c.units{i};
    return;
  endif
  unit = units{find (strcmp (strcat (c.measured, "_ref"), c.references{i}), 1)};
endfunction

function k = places (who, c, field, names, known, what)
  k = vec (gs.given.places_of (names, known), 2);
  if (! all (k))
    error ("%s: the controller %s: %s: expected the name of an %s; found %s", who, c.name, field,
           what, gs.text.nearest_word (names{find (! k, 1)}, known));
  endif
endfunction

function text = connection (c, name, k, reads, drives, nv)
  dims = max ([numel(reads), numel(c.references), numel(drives)], 1);
  out = {sprintf("      SUBROUTINE %s_CD%d( T, Y, XK, CST, V )", name, k), ...
         sprintf("C     The controller %s on the outputs and inputs of the scene.", c.name), ...
         "      IMPLICIT NONE", "      DOUBLE PRECISION   T, Y(*), XK(*), CST(*), V(*)", ...
         sprintf("      DOUBLE PRECISION   YC(%d), R(%d), U(%d)", dims), ...
         sprintf("      EXTERNAL %s_CN%d", name, k), "C"};
  for i = 1:numel (reads)
    out{end+1} = sprintf ("      YC(%d) = Y(%d)", i, reads(i));
  endfor
  for i = 1:numel (c.references)
    out{end+1} = sprintf ("      R(%d) = V(%d)", i, nv + i);
  endfor
  out{end+1} = sprintf ("      CALL %s_CN%d( YC, R, XK, U )", name, k);
  for i = 1:numel (drives)
    out{end+1} = sprintf ("      V(%d) = U(%d)", drives(i), i);
  endfor
  out{end+1} = "      END";
  text = sprintf ("%s\n", out{:});
endfunction

## CTL and CTP of all
function text = entry (json, before, list, name)
  own = before.dimensions.nctl;
  at = before.dimensions.nxk + 1;
  out = {sprintf("      SUBROUTINE %s_CTL( K, T, Y, XK, CST, V )", name), ...
         "      IMPLICIT NONE", "      INTEGER            K", ...
         "      DOUBLE PRECISION   T, Y(*), XK(*), CST(*), V(*)", "C"};
  if (own > 0)
    out{end+1} = sprintf ("      IF ( K.LE.%d ) CALL %s_CTO( K, T, Y, XK, CST, V )", own, name);
  endif
  for k = 1:numel (list)
    out = [out, {sprintf("      IF ( K.EQ.0 .OR. K.EQ.%d )", own + k), ...
                 sprintf("     $   CALL %s_CD%d( T, Y, XK(%d), CST, V )", name, k, at)}];
    at += rows (list{k}.A);
  endfor
  out = [out, {"      END", sprintf("      SUBROUTINE %s_CTP( CST, PER, DEL )", name), ...
               "      IMPLICIT NONE", "      DOUBLE PRECISION   CST(*), PER(*), DEL(*)", "C"}];
  if (own > 0)
    out{end+1} = sprintf ("      CALL %s_CTQ( CST, PER, DEL )", name);
  endif
  for k = 1:numel (list)
    out{end+1} = sprintf ("      PER(%d) = %s", own + k, gs.text.fortran_number (list{k}.period));
    out{end+1} = sprintf ("      DEL(%d) = %s", own + k, gs.text.fortran_number (list{k}.delay));
  endfor
  out{end+1} = "      END";
  text = sprintf ("%s\n", out{:});
endfunction

function list = full_names (json)
  list = cellfun (@(row) row.name, gs.model.json_rows (json, "subroutines"), "UniformOutput", ...
                  false);
endfunction

## CTD: derivatives of the sample of one of them; BEFORE: the scene without them
function text = slopes (json, before, list, name)
  d = json.dimensions;
  n = d.nv + d.nxk;
  at = struct ("sizes", [d.nv, d.nxk], "nv", before.dimensions.nv, "xk", 0);
  out = {sprintf("      SUBROUTINE %s_CTD( K, T, Y, XK, CST, V, D )", name), ...
         "      IMPLICIT NONE", "      INTEGER            K, I, J", ...
         sprintf("      DOUBLE PRECISION   T, Y(*), XK(*), CST(*), V(*), D(%d,*)", n), ...
         sprintf("      DO 20 J = 1, %d", n + d.ny + numel (cellstr (json.sensitivity))), ...
         sprintf("      DO 10 I = 1, %d", n), ...
         "      D(I,J) = 0.0D0", "      IF ( I.EQ.J ) D(I,J) = 1.0D0", "   10 CONTINUE", ...
         "   20 CONTINUE"};
  text = "";
  rows_ = gs.model.json_rows (json, "controllers");
  for k = 1:numel (list)
    [at.reads, at.drives] = deal (rows_{k}.reads, rows_{k}.outputs);
    part = sprintf ("%s_CE%d", name, k);
    out{end+1} = sprintf ("      IF ( K.EQ.%d ) CALL %s( Y, XK, V, D )", k, part);
    text = [text, gs.controller.slope_text(list{k}, part, at)];
    at.nv += numel (list{k}.references);
    at.xk += rows (list{k}.A);
  endfor
  text = [text, sprintf("%s\n", out{:}, "      END")];
endfunction

## rows for CTL and CTP; the inputs V of all are as many as there are now
function list = subroutines (json, name)
  list = gs.model.json_rows (json, "subroutines");
  full = cellfun (@(row) row.name, list, "UniformOutput", false);
  list(ismember (full, strcat (name, {"_CTL", "_CTP", "_CTD"}))) = [];
  for k = 1:numel (list)
    if (isfield (list{k}, "shapes") && ! isempty (list{k}.shapes))
      v = strcmp (cellstr (list{k}.arguments)(:)', "V");
      shapes = cellstr (list{k}.shapes)(:)';
      shapes(v) = regexprep (shapes(v), '^(in|inout)\(.*\)$', ...
                             sprintf ("$1(%d)", json.dimensions.nv));
      list{k}.shapes = shapes;
    endif
  endfor
  list{end+1} = struct ("name", [name "_CTL"]);
  list{end+1} = struct ("name", [name "_CTP"]);
endfunction
