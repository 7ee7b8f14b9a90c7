## files = gs.controller.target_files (who, c, folder, scene)
## The controller C of gsmbp_model_control alone, in FOLDER: NAME.f; NAME.c, NAME.h with the scene's
## C and the run time that both call.  SCENE: its file, derived again with the routines that the
## controller calls and no others.

function files = target_files (who, c, folder, scene)
  if (! (ischar (scene) && ! isempty (scene)))
    error (["%s: the controller %s (%s) calculates with subroutines of %s: expected the file " ...
            "of this scene as the third argument, found %s"], who, c.name, c.method, ...
           c.scene.name, {gs.text.shown_value(scene), "none"}{1 + isempty(scene)});
  endif
  [~, name] = fileparts (scene);
  if (! strcmp (name, c.scene.name))
    error ("%s: the controller %s: expected the file of the scene %s, found %s", who, c.name, ...
           c.scene.name, scene);
  elseif (exist (scene, "file") != 2)
    error ("%s: there is no scene file %s", who, scene);
  elseif (strcmpi (c.name, c.scene.name))
    error ("%s: the controller %s: expected another name than that of its scene", who, c.name);
  endif
  place = tempname ();
  gs.files.make_folder (who, place);
  guard = onCleanup (@() remove (place));
  derive (who, c, scene, place);
  json = jsondecode (fileread (fullfile (place, [name ".json"])), "makeValidName", false);
  if (! strcmp (json.scene_hash, c.scene.hash))
    error (["%s: the controller %s: expected the file of the scene that it was made for (%s, " ...
            "hash %s), found hash %s in %s"], who, c.name, name, c.scene.hash, json.scene_hash, ...
           scene);
  endif
  t = struct ("json", json, "name", name, "nz", rows (c.A), "cst", json.dimensions.ncst, ...
              "drives", vec (gs.given.places_of (c.driven, ...
                                                 gs.given.names_and_units (json.inputs)), 2), ...
              "values", values_of (c, json));
  files = {write_fortran(who, c, t, folder, place)};
  files = [files, write_c(who, c, t, folder, place)];
endfunction

## of its parameters, as the controller believes them; those that were compiled into the model are
## the scene's
function values = values_of (c, json)
  values = [json.parameters.value];
  [known, at] = ismember (gs.given.names_and_units (json.parameters), ...
                          fieldnames (c.scene.parameters));
  believed = struct2cell (c.scene.parameters);
  values(known) = [believed{at(known)}];
endfunction

function remove (place)
  confirm_recursive_rmdir (false, "local");
  rmdir (place, "s");
endfunction

## the scene with the requests of the controller, as Fortran and C
function derive (who, c, scene, place)
  asked = {"inverse", "mass"};
  if (isfield (c, "through"))
    asked = [{"mass"}, {"closure"}(1:+c.through.loops), ...
             struct("cmd", "command", "cmq", "quasi_static").(c.through.command), ...
             {"points", "point_jacobians"}(1:2 * c.through.cartesian)];
  endif
  plain = @(text) strrep (strrep (text, '\', '\\'), '"', '\"');
  [~, name] = fileparts (scene);
  copy = fullfile (place, [name ".mac"]);
  statements = ["load(\"%s\")$\nrequests : [%s]$\n" ...
                "gsmbp_c(scene, requests, [directory = \"%s\"])$\n"];
  gs.files.write_text (who, copy, sprintf (statements, plain (make_absolute_filename (scene)), ...
                                           strjoin (asked, ", "), plain (place)));
  warning ("off", "gsmbp:derive", "local");   # said when the model was derived
  gs.model.run_maxima (who, gs.files.own_place ("share", "make", "derive"), copy, place);
endfunction

## one file: the controller, the scene's subroutines, what these call of share/fortran
function file = write_fortran (who, c, t, folder, place)
  text = [gs.controller.target_fortran(c, t), fileread(fullfile (place, [t.name ".f"]))];
  more = cellfun (@fileread, gs.controller.target_needs (text, "f"), "UniformOutput", false);
  file = fullfile (folder, [c.name ".f"]);
  gs.files.write_text (who, file, [text, more{:}]);
endfunction

function files = write_c (who, c, t, folder, place)
  [source, header] = gs.controller.target_c (c, t);
  texts = {[c.name ".c"], source; [c.name ".h"], header};
  for kind = {".c", ".h"}
    file = [t.name kind{1}];
    texts(end+1,:) = {file, fileread(fullfile (place, file))};
  endfor
  needed = gs.controller.target_needs ([source, texts{3,2}], "c");
  headers = glob (gs.files.own_place ("share", "engine", "core", "gsmbp", "*.h"))';
  parts = [needed, {gs.files.own_place("share", "controllers", "controllers.h")}, headers];
  for file = parts
    [~, base, kind] = fileparts (file{1});
    inside = {"", "gsmbp"}{1 + any (strcmp (file{1}, headers))};
    texts(end+1,:) = {fullfile(inside, [base kind]), fileread(file{1})};
  endfor
  gs.files.make_folder (who, fullfile (folder, "gsmbp"));
  files = cellfun (@(name) fullfile (folder, name), texts(:,1)', "UniformOutput", false);
  for k = 1:numel (files)
    gs.files.write_text (who, files{k}, texts{k,2});
  endfor
endfunction
