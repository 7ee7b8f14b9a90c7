## [json, texts] = gs.model.scene_files (name, source, description)
## The description of the scene NAME and the texts of its Fortran and of it; an error
## where one of them is cut off, or where they are not of one derivation of that scene.

function [json, texts] = scene_files (name, source, description)
  for file = {source, description}
    if (! exist (file{1}, "file"))
      error (["gsmbp_build: there is no %s; emit it first: gsmbp_fortran in Maxima, " ...
              "or `make fortran_out/%s.f`%s"], file{1}, name, elsewhere (name, file{1}));
    elseif (isfolder (file{1}))
      error ("gsmbp_build: %s: expected a file, found a folder of this name", file{1});
    elseif (stat (file{1}).size == 0)
      refuse ("%s is empty", file{1});
    endif
  endfor
  texts = {fileread(source), fileread(description)};
  try
    json = jsondecode (texts{2});
  catch
    json = [];
  end_try_catch
  check_description (json, description, name);
  check_fortran (json, source, texts{1});
  same_description (source, description, texts{:});
endfunction

## where Maxima writes if it runs in the working directory
function text = elsewhere (name, wanted)
  text = "";
  here = make_absolute_filename ("fortran_out");
  if (! strcmp (fileparts (wanted), here) && exist (fullfile (here, [name ".f"]), "file") == 2)
    text = sprintf ("; or give option directory: there is one in %s", here);
  endif
endfunction

function refuse (template, varargin)
  error (["gsmbp_build: " template "; derive the scene again (gsmbp_fortran)"], varargin{:});
endfunction

function check_description (json, description, name)
  needed = {"name", "dimensions", "subroutines", "parameters", "command_order", "actuated"};
  if (! (isstruct (json) && isscalar (json) && all (isfield (json, needed))))
    refuse ("%s is no whole description of a scene (JSON with %s)", description,
            strjoin (needed, ", "));
  endif
  plain = strrep (strrep (name, "+", ""), "-", "m");   # as share/make/derive names files
  if (! (ischar (json.name) && strcmp (json.name, plain)))
    refuse ("%s describes the scene %s, expected %s", description, gs.text.shown_value (json.name),
            plain);
  endif
endfunction

## the sum of the description that the head of the Fortran states (Adler-32, of ASCII characters)
function same_description (source, description, fortran, text)
  told = regexp (fortran, '^C     Checksum of the \.json that describes it: (\d+) (\d+)\.', ...
                 "tokens", "once", "lineanchors");
  if (isempty (told))
    return;
  endif
  text = strrep (text, "\r", "");
  a = mod (cumsum ([1, double(text(text < 128))]), 65521);
  b = mod (sum (a(2:end)), 65521);
  if (! isequal (str2double (told(:)'), [b, a(end)]))
    refuse ("%s is not the description that %s was emitted with: they are of two derivations", ...
            description, source);
  endif
endfunction

## every subroutine that the description names is there with its arguments, and ends
function check_fortran (json, source, text)
  text = strrep (strrep (text, "\r", ""), "\t", " ");
  code = regexprep (text, "\n     [^ \n]", "");   # continuation lines
  heads = regexp (code, '^ +SUBROUTINE +(\w+) *\(([^)]*)\)', "tokens", "lineanchors");
  names = cellfun (@(h) h{1}, heads, "UniformOutput", false);
  list = json.subroutines;
  if (! isstruct (list))
    list = struct ("name", {});
  endif
  for one = list(:)'
    here = find (strcmpi (names, one.name), 1);
    if (isempty (here))
      refuse (["%s has no SUBROUTINE %s, which the .json beside it names: " ...
               "one of them is cut off or of another derivation"], source, one.name);
    endif
    if (isfield (one, "arguments"))
      same_arguments (source, one, strrep (strrep (heads{here}{2}, " ", ""), "\n", ""));
    endif
  endfor
  if (isempty (regexp (code, '\n +END *\n*$', "once")))
    refuse ("%s is cut off: expected END in its last line", source);
  endif
  same_size (json, source, code, "PAR", "npar", "parameters");
  same_size (json, source, code, "CST", "ncst", "constants");
endfunction

function same_arguments (source, one, given)
  told = cellstr (one.arguments)(:)';
  if (! strcmpi (given, sprintf (",%s", told{:})(2:end)))
    refuse (["%s: SUBROUTINE %s has the arguments (%s), the .json beside it says (%s): " ...
             "they are of two derivations"], source, one.name, strrep (given, ",", ", "),
            strjoin (told, ", "));
  endif
endfunction

## the arrays of parameters and constants are as long as the description says
function same_size (json, source, code, array, field, what)
  found = regexp (code, ['DOUBLE PRECISION[^\n]*\<' array '\((\d+)\)'], "tokens", "once");
  if (isempty (found) || ! isfield (json.dimensions, field))
    return;
  endif
  told = json.dimensions.(field);
  if (str2double (found{1}) != max (1, told))
    refuse ("%s has %s %s, the .json beside it says %d: they are of two derivations", source,
            found{1}, what, told);
  endif
endfunction
