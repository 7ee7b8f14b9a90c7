## gsmbp__fits (who, what, value, kind)
## An error of WHO about WHAT unless VALUE is of that KIND: "flag", "number" (real,
## finite), "positive", "whole" (a whole number >= 0), "numbers" (an array of real,
## finite ones), "list" (a vector of such), "text", "names" (a text or a cell array of
## texts), or one of the words of a cell array; [low, high]: a number within; "tolerance": a
## number above 0 and below 1; "nonnegative": a finite number >= 0; "any": WHO looks at it later.

function gsmbp__fits (who, what, value, kind)
  numbers = isnumeric (value) && isreal (value) && all (isfinite (value(:)));
  one = numbers && isscalar (value);
  if (isnumeric (kind))
    wanted = sprintf ("a number from %g to %g", kind);
    fits = one && value >= kind(1) && value <= kind(2);
  elseif (iscell (kind))
    fits = ischar (value) && any (strcmp (value, kind));
    wanted = ["one of \"" strjoin(kind, "\", \"") "\""];
  else
    switch (kind)
      case "flag"
        truth = one || (islogical (value) && isscalar (value));
        [wanted, fits] = deal ("true or false", truth && any (value == [0, 1]));
      case "number"
        [wanted, fits] = deal ("a finite number", one);
      case "positive"
        [wanted, fits] = deal ("a finite number above 0", one && value > 0);
      case "nonnegative"
        [wanted, fits] = deal ("a finite number >= 0", one && value >= 0);
      case "tolerance"
        [wanted, fits] = deal ("a number above 0 and below 1", one && value > 0 && value < 1);
      case "any"
        [wanted, fits] = deal ("", true);
      case "whole"
        whole = one && value >= 0 && value == fix (value);
        [wanted, fits] = deal ("a whole number >= 0", whole);
      case "numbers"
        [wanted, fits] = deal ("finite numbers", numbers);
      case "list"
        list = numbers && (isempty (value) || isvector (value));
        [wanted, fits] = deal ("a vector of finite numbers", list);
      case "text"
        [wanted, fits] = deal ("a text", ischar (value) && rows (value) <= 1);
      case "names"
        listed = ischar (value) || iscellstr (value);
        [wanted, fits] = deal ("a name or a list of names", listed);
    endswitch
  endif
  if (! fits)
    error ("%s: %s: expected %s, found %s", who, what, wanted, gsmbp__shown (value));
  endif
endfunction
