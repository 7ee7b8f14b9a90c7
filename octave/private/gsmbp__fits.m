## gsmbp__fits (who, what, value, kind)
## An error of WHO about WHAT unless VALUE is of that KIND: "flag", "number" (real,
## finite), "positive", "whole" (a whole number >= 0), "numbers" (an array of real,
## finite ones), "text", "names" (a text or a cell array of texts), or one of the words
## of a cell array.

function gsmbp__fits (who, what, value, kind)
  numbers = (isnumeric (value) || islogical (value)) && isreal (value) ...
            && all (isfinite (value(:)));
  one = numbers && isscalar (value);
  if (iscell (kind))
    fits = ischar (value) && any (strcmp (value, kind));
    wanted = ["one of \"" strjoin(kind, "\", \"") "\""];
  else
    all_kinds = {"flag", "true or false", one && any (value == [0, 1]); ...
                 "number", "a finite number", one; ...
                 "positive", "a finite number above 0", one && value > 0; ...
                 "whole", "a whole number >= 0", one && value >= 0 && value == fix (value); ...
                 "numbers", "finite numbers", numbers; ...
                 "text", "a text", ischar (value) && rows (value) <= 1; ...
                 "names", "a name or a list of names", ischar (value) || iscellstr (value)};
    k = strcmp (kind, all_kinds(:,1));
    [wanted, fits] = all_kinds{k,2:3};
  endif
  if (! fits)
    error ("%s: %s: expected %s, found %s", who, what, wanted, gsmbp__shown (value));
  endif
endfunction
