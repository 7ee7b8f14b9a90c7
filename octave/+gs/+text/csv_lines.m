## [lines, numbers] = gs.text.csv_lines (who, file)
## The lines of a table between commas that are neither empty nor remarks (#), and their numbers; a
## mark of UTF-8 and carriage returns are left out.

function [lines, numbers] = csv_lines (who, file)
  [f, reason] = fopen (file, "r");
  if (f < 0)
    error ("%s: cannot read %s: %s", who, file, reason);
  endif
  text = fread (f, Inf, "uint8=>char")';
  fclose (f);
  if (strncmp (text, "\357\273\277", 3))
    text(1:3) = [];
  endif
  lines = strtrim (strsplit (strrep (text, "\r", ""), "\n"));
  numbers = find (! cellfun (@(l) isempty (l) || l(1) == "#", lines));
  lines = lines(numbers);
endfunction
