## text = gs.model.sizes_header (json, symbol, has_input)
## The macros of glue/gsmbp_scene.c for the scene of a decoded JSON, whose module has that SYMBOL;
## sizes are those that gsmbp_scene.h lists.

function text = sizes_header (json, symbol, has_input)
  header = fileread (gs.files.own_place ("octave", "glue", "gsmbp_scene.h"));
  members = {[".name = \"" json.name "\""], [".symbol = \"" symbol "\""], ...
             [".left_out = \"" left_out(json) "\""]};
  for name = sizes_in (header)
    members{end+1} = sprintf (".%s = %d", name{1}, size_of (json.dimensions, name{1}));
  endfor
  base = 0;
  if (isfield (json, "base_parameters"))
    base = numel (json.base_parameters);
  endif
  by = 0;
  if (isfield (json, "sensitivity"))
    by = numel (cellstr (json.sensitivity));
  endif
  sets = gs.model.orientation_sets (json);
  skeleton = gs.model.scene_skeleton (json);
  np = sum (skeleton.points) + numel ([skeleton.parts.bodies]);
  modes = 0;
  if (isfield (json, "events") && ! isempty (json.events))
    modes = [json.events.input, 0];
  endif
  members{end+1} = sprintf (".redundant = %d", redundant (json));
  members{end+1} = sprintf (".np = %d, .nbase = %d, .nsp = %d, .nsets = %d", np, base, by, ...
                            rows (sets));
  [routines, meanings, declared, names] = subroutines (json);
  if (has_input)
    names{end+1} = "vin";
    declared{end+1} = "gsvin_";
    members{end+1} = ".vin = (gsmbp_sub) gsvin_";
  endif
  [by_value, run] = of_the_run (json, names, declared, by);
  others = cellfun (@(sub) sprintf ("extern void %s (void); ", sub), declared(! by_value), ...
                    "UniformOutput", false);
  called = cellfun (@(name, sub) sprintf ("GS_FORTRAN_%s (run_%s, %s) ", name, name, sub), ...
                    names(by_value), declared(by_value), "UniformOutput", false);
  [lists, about, of_plan] = gs.model.scene_tables (json, names);
  text = [sprintf("#define GSMBP_INSTALL G%s\n", symbol), ...
          "#define GSMBP_DECLARE ", others{:}, "\n", ...
          "#define GSMBP_BY_VALUE ", called{:}, "\n", ...
          "#define GSMBP_RUN ", run, ", ", of_plan, "\n", ...
          "#define GSMBP_LISTS ", lists, "\n", ...
          "#define GSMBP_ABOUT ", about, "\n", ...
          "#define GSMBP_SETS ", strjoin(cellstr (num2str ([sets'(:); 0])), ", "), "\n", ...
          "#define GSMBP_MODES ", sprintf("%d, ", modes), "\n", ...
          "#define GSMBP_TABLE ", strjoin(members, ", "), "\n", ...
          "#define GSMBP_ROUTINES ", routines{:}, "\n#define GSMBP_MEANINGS ", meanings{:}, "\n"];
endfunction

## a size, 0 where the JSON does not say
function n = size_of (d, name)
  n = 0;
  if (isfield (d, name))
    n = d.(name);
  endif
endfunction

## how many rows of the constraints are redundant in general, as the derivation found
function n = redundant (json)
  n = 0;
  if (isfield (json, "mobility") && isfield (json.mobility, "rank"))
    n = json.mobility.rows - json.mobility.rank;
  endif
endfunction

## the requests that were asked for and are not there, with their reasons, as a constant of C
function text = left_out (json)
  text = "";
  if (isfield (json, "left_out") && isstruct (json.left_out))
    for one = json.left_out(:)'
      text = [text, "\n", one.request, ": ", one.reason];
    endfor
  endif
  text = strrep (undo_string_escapes ([text "\n"]), "?", "\\?");
endfunction

## which subroutines are members of the scene as runs take it (gs_scene), and its members in C
function [by_value, run] = of_the_run (json, names, declared, by)
  header = fileread (gs.files.own_place ("share", "engine", "host", "fortran_scene.h"));
  known = [regexp(header, '#define GS_FORTRAN_([a-z]\w+)', "tokens"){:}];
  by_value = ismember (names, known);
  members = {[".name = \"" json.name "\""], sprintf(".nsp = %d", by)};
  for name = {"nq", "nu", "nx", "nv", "ny", "nlam", "nsw", "nev", "nctl", "nxk"}
    members{end+1} = sprintf (".%s = %d", name{1}, size_of (json.dimensions, name{1}));
  endfor
  for name = setdiff (names(by_value), {"rha", "mar"})
    members{end+1} = sprintf (".%s = run_%s", name{[1, 1]});
  endfor
  run = strjoin (members, ", ");
endfunction

## rows of C: the emitted subroutines by the ends of their names, the sentences of their INFO
function [routines, meanings, declared, names] = subroutines (json)
  routines = meanings = declared = names = {};
  list = json.subroutines;
  if (! iscell (list))
    list = num2cell (list);
  endif
  for row = list(:)'
    full = tolower (row{1}.name);
    name = full(numel (json.name)+2:end);
    declared{end+1} = [full "_"];
    names{end+1} = name;
    routines{end+1} = sprintf ("{ \"%s\", (gsmbp_sub) %s_, \"%s\" }, ", name, full, ...
                               gs.model.routine_signature (row{1}));
    if (isfield (row{1}, "info") && ! isempty (row{1}.info))
      told = row{1}.info([row{1}.info.code] > 0)(:)';
      meanings = [meanings, arrayfun(@(one) sentence (name, one), told, "UniformOutput", false)];
    endif
  endfor
endfunction

function row = sentence (name, info)
  above = " (and so does every greater INFO)";
  row = sprintf ("{ \"%s\", %d, %d, \"%s\" }, ", name, info.code, ...
                 ! isempty (strfind (info.meaning, above)), ...
                 regexprep (strrep (info.meaning, above, ""), '(["\\])', '\\$1'));
endfunction

## the names in the list X (one) X (two) ... of a header
function names = sizes_in (header)
  body = regexp (header, '#define GSMBP_SIZES\(X\)((?:[^\n]*\\\n)*[^\n]*)', "tokens", "once"){1};
  names = [regexp(body, 'X \((\w+)\)', "tokens"){:}];
endfunction
