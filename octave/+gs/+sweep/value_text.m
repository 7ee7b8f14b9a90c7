## text = gs.sweep.value_text (x)
## A value in one line, of which no other value has the same: what is long by its sum.

function text = value_text (x)
  if (ischar (x) && rows (x) <= 1)
    text = ["\"" x "\""];
  elseif (isstruct (x))
    of_field = @(name) [name ": " gs.sweep.value_text({x.(name)})];
    text = ["{" strjoin(cellfun (of_field, fieldnames (x)', "UniformOutput", false), ", ") "}"];
  elseif (iscell (x))
    text = ["{" strjoin(cellfun (@gs.sweep.value_text, x(:)', "UniformOutput", false), ", ") "}"];
    if (! isrow (x))
      text = sprintf ("%dx%d %s", rows (x), columns (x), text);
    endif
  elseif (is_function_handle (x))
    text = func2str (x);
    with = functions (x);
    if (isfield (with, "workspace") && numfields (with.workspace{1}) > 0)
      text = [text ", sum of its variables " hash("md5", gs.sweep.value_text (with.workspace{1}))];
    endif
  elseif (isobject (x))   # a linear model
    text = [class(x) " " gs.sweep.value_text(struct (x))];
  elseif (numel (x) <= 20 && ndims (x) == 2)
    text = mat2str (x, 17);
  else
    text = sprintf ("%s of %s, sum %s", strjoin (arrayfun (@num2str, size (x), "UniformOutput", ...
                                                           false), "x"), class (x), ...
                    hash ("md5", char (typecast (double (x(:)'), "uint8"))));
  endif
  text = strrep (text, "\n", " ");
endfunction
