## gs.given.check_kind (who, what, value, kind)
## An error of WHO about WHAT unless VALUE is of that KIND: "flag", "number" (real,
## finite), "positive", "whole" (a whole number >= 0), "numbers" (an array of real,
## finite ones), "list" (a vector of such), "text", "names" (a text or a cell array of
## texts), or one of the words of a cell array; [low, high]: a number within; "tolerance": a
## number above 0 and below 1; "nonnegative": a finite number >= 0; "steps": maxsteps;
## "any": WHO looks at it later.  Texts: share/engine/core/gsmbp/options.h.

function check_kind (who, what, value, kind)
  numbers = isnumeric (value) && isreal (value) && all (isfinite (value(:)));
  one = numbers && isscalar (value);
  if (isnumeric (kind))
    fits = one && value >= kind(1) && value <= kind(2);
  elseif (iscell (kind))
    fits = ischar (value) && any (strcmp (value, kind));
  else
    switch (kind)
      case "flag"
        fits = (one || (islogical (value) && isscalar (value))) && any (value == [0, 1]);
      case "number"
        fits = one;
      case "positive"
        fits = one && value > 0;
      case "nonnegative"
        fits = one && value >= 0;
      case "tolerance"
        fits = one && value > 0 && value < 1;
      case "any"
        fits = true;
      case {"whole", "steps"}
        most = [Inf, gs.text.run_limit("fixed_steps")](1 + strcmp (kind, "steps"));
        fits = one && value >= 0 && value == fix (value) && value <= most;
      case "numbers"
        fits = numbers;
      case "list"
        fits = numbers && (isempty (value) || isvector (value));
      case "text"
        fits = ischar (value) && rows (value) <= 1;
      case "names"
        fits = ischar (value) || iscellstr (value);
    endswitch
  endif
  if (! fits)
    error ("%s: %s: expected %s, found %s", who, what, wanted (kind), gs.text.shown_value (value));
  endif
endfunction

function text = wanted (kind)
  if (isnumeric (kind))
    text = sprintf ("a number from %g to %g", kind);
  elseif (iscell (kind))
    text = ["one of \"" strjoin(kind, "\", \"") "\""];
  else
    kinds = gs.text.table_rows ("GS_KINDS");
    text = kinds{strcmp (kinds(:,1), kind),2};
  endif
endfunction
