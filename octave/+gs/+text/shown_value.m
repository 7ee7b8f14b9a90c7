## text = gs.text.shown_value (value)
## A value of the user in an error, in one line: a short one as it is typed, else
## its class and size.

function text = shown_value (value)
  if (ischar (value) && rows (value) <= 1 && numel (value) <= 60)
    text = ["\"" undo_string_escapes(value) "\""];
  elseif ((isnumeric (value) || islogical (value)) && numel (value) <= 6 && ndims (value) == 2)
    if (! islogical (value))
      value = double (value);
    endif
    text = mat2str (value, 6);
  elseif (iscell (value) && isrow (value) && numel (value) <= 4 && all (cellfun (@plain, value)))
    text = ["{" strjoin(cellfun (@gs.text.shown_value, value, "UniformOutput", false), ", ") "}"];
  elseif (isstruct (value) && isscalar (value) && isempty (fieldnames (value)))
    text = "a struct without fields";
  elseif (is_function_handle (value))
    text = "a function handle";
  else
    text = sprintf ("a %s of size %s", class (value), sprintf ("%dx", size (value))(1:end-1));
  endif
endfunction

function is = plain (x)
  is = (ischar (x) && rows (x) <= 1 && numel (x) <= 20) || (isnumeric (x) && isscalar (x));
endfunction
