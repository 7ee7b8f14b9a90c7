## [json, texts] = gsmbp__scene_files (name, source, description)
## The description of the scene NAME and the texts of its Fortran and of it; an error
## where one of them is cut off, or where they are not of one derivation of that scene.

function [json, texts] = gsmbp__scene_files (name, source, description)
  again = "derive the scene again (gsmbp_fortran)";
  for file = {source, description}
    if (! exist (file{1}, "file"))
      error ("gsmbp_build: there is no %s; emit it first: gsmbp_fortran in Maxima, or `make fortran_out/%s.f`", file{1}, name);
    elseif (stat (file{1}).size == 0)
      error ("gsmbp_build: %s is empty: %s", file{1}, again);
    endif
  endfor
  texts = {fileread(source), fileread(description)};
  try
    json = jsondecode (texts{2});
  catch
    json = [];
  end_try_catch
  needed = {"name", "dimensions", "subroutines", "parameters", "command_order", "actuated"};
  if (! (isstruct (json) && isscalar (json) && all (isfield (json, needed))))
    error ("gsmbp_build: %s is no whole description of a scene (JSON with %s): %s", description, strjoin (needed, ", "), again);
  endif
  plain = strrep (strrep (name, "+", ""), "-", "m");   # as share/make/derive names files
  if (! (ischar (json.name) && strcmp (json.name, plain)))
    error ("gsmbp_build: %s describes the scene %s, expected %s: %s", description, gsmbp__shown (json.name), plain, again);
  endif
  check_fortran (json, source, texts{1}, again);
endfunction

## every subroutine that the description names is there with its arguments, and ends
function check_fortran (json, source, text, again)
  text = strrep (strrep (text, "\r", ""), "\t", " ");
  code = regexprep (text, "\n     [^ \n]", "");   # continuation lines
  heads = regexp (code, '^ +SUBROUTINE +(\w+) *\(([^)]*)\)', "tokens", "lineanchors");
  names = cellfun (@(h) h{1}, heads, "UniformOutput", false);
  list = json.subroutines;
  if (isstruct (list))
    list = num2cell (list);
  endif
  for k = 1:numel (list)
    one = list{k};
    if (! isstruct (one) || ! isfield (one, "name"))
      continue;
    endif
    here = find (strcmpi (names, one.name), 1);
    if (isempty (here))
      error ("gsmbp_build: %s has no SUBROUTINE %s, which the .json beside it names: one of them is cut off or of another derivation; %s", source, one.name, again);
    endif
    given = strtrim (strsplit (heads{here}{2}, ","));
    if (isfield (one, "arguments") && ! isequal (upper (given), upper (cellstr (one.arguments)(:)')))
      error ("gsmbp_build: %s: SUBROUTINE %s has the arguments (%s), the .json beside it says (%s): they are of two derivations; %s", source, one.name,
             strjoin (given, ", "), strjoin (cellstr (one.arguments)(:)', ", "), again);
    endif
  endfor
  if (isempty (regexp (code, '\n +END *\n*$', "once")))
    error ("gsmbp_build: %s is cut off: expected END in its last line; %s", source, again);
  endif
  for size_ = {"PAR", "npar"; "CST", "ncst"}'
    same_size (json, source, code, size_{1}, size_{2}, again);
  endfor
endfunction

## the arrays of parameters and constants are as long as the description says
function same_size (json, source, code, array, field, again)
  found = regexp (code, ['DOUBLE PRECISION[^\n]*\<' array '\((\d+)\)'], "tokens", "once");
  if (isempty (found) || ! isfield (json.dimensions, field))
    return;
  endif
  if (str2double (found{1}) != max (1, json.dimensions.(field)))
    error ("gsmbp_build: %s has %s %s, the .json beside it says %d: they are of two derivations; %s", source, found{1}, {"parameters", "constants"}{1 + strcmp(array, "CST")},
           json.dimensions.(field), again);
  endif
endfunction
