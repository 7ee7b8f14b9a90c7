## options = gsmbp__options (who, defaults, pairs)
## The struct DEFAULTS with the name-value pairs of the cell array PAIRS put
## in (or the fields of one struct).  An unknown name is an error of WHO.

function options = gsmbp__options (who, defaults, pairs)
  options = defaults;
  if (numel (pairs) == 1 && isstruct (pairs{1}))
    given = pairs{1};
    pairs = [fieldnames(given), struct2cell(given)]'(:)';
  endif
  if (mod (numel (pairs), 2) != 0)
    error ("%s: options must be name-value pairs", who);
  endif
  known = fieldnames (defaults);
  for i = 1:2:numel (pairs)
    name = pairs{i};
    if (! ischar (name))
      error ("%s: expected the name of an option, found a %s", who, class (name));
    endif
    if (! any (strcmp (name, known)))
      error ("%s: unknown option \"%s\"; known: %s", who, name, strjoin (sort (known)', ", "));
    endif
    options.(name) = pairs{i+1};
  endfor
endfunction
