## options = gsmbp__options (who, defaults, pairs, kinds)
## The struct DEFAULTS with the name-value pairs of the cell array PAIRS put
## in (or the fields of one struct).  An unknown name is an error of WHO, and so is a
## value that is not of the kind that the struct KINDS (may be left out) says for its
## name: a word of gsmbp__fits, or a list of the words allowed.  What is empty by
## default may be given empty.

function options = gsmbp__options (who, defaults, pairs, kinds = struct ())
  options = defaults;
  if (numel (pairs) == 1 && isstruct (pairs{1}) && isscalar (pairs{1}))
    given = pairs{1};
    pairs = [fieldnames(given), struct2cell(given)]'(:)';
  endif
  if (mod (numel (pairs), 2) != 0)
    error ("%s: options must be name-value pairs", who);
  endif
  known = fieldnames (defaults);
  for i = 1:2:numel (pairs)
    [name, value] = pairs{i:i+1};
    if (! ischar (name))
      error ("%s: expected the name of an option, found a %s", who, class (name));
    endif
    if (! any (strcmp (name, known)))
      error ("%s: unknown option \"%s\"; known: %s", who, name, strjoin (sort (known)', ", "));
    endif
    left_out = isempty (value) && isempty (defaults.(name)) ...
               && (isequal (value, []) || strcmp (class (value), class (defaults.(name))));
    if (isfield (kinds, name) && ! left_out)
      gsmbp__fits (who, ["option " name], value, kinds.(name));
    endif
    options.(name) = value;
  endfor
endfunction
