## [heads, values, units] = gsmbp__csv_columns (who, file)
## A table of numbers between commas: the heads of its columns without their units, the numbers, the
## units that stand in brackets behind the heads ("" where there are none).

function [heads, values, units] = gsmbp__csv_columns (who, file)
  [f, reason] = fopen (file, "r");
  if (f < 0)
    error ("%s: cannot read %s: %s", who, file, reason);
  endif
  text = fread (f, Inf, "uint8=>char")';
  fclose (f);
  lines = strsplit (strrep (text, "\r", ""), "\n");
  numbers = find (! cellfun (@(l) isempty (strtrim (l)) || l(1) == "#", lines));
  if (numel (numbers) < 2)
    error ("%s: %s: expected a line of heads and lines of numbers, found %d lines", who, file, ...
           numel (numbers));
  endif
  cells = strtrim (strsplit (lines{numbers(1)}, ",", "CollapseDelimiters", false));
  for c = 1:numel (cells)
    token = regexp (cells{c}, '^([^\[]*?)\s*(?:\[(.*)\])?$', "tokens", "once");
    token(end+1:2) = {""};
    [heads{c}, units{c}] = token{1:2};
    if (any (strcmp (heads(1:c-1), heads{c})))
      error ("%s: %s: the head %s is there twice", who, file, heads{c});
    endif
  endfor
  values = numbers_of (who, file, lines, numbers(2:end), numel (heads));
endfunction

function values = numbers_of (who, file, lines, numbers, n)
  values = zeros (numel (numbers), n);
  for k = 1:numel (numbers)
    [row, count, message] = sscanf (lines{numbers(k)}, "%f,", [1, Inf]);
    if (numel (row) == n && sum (lines{numbers(k)} == ",") == n - 1 && all (isfinite (row)))
      values(k,:) = row;
      continue;
    endif
    cells = strtrim (strsplit (lines{numbers(k)}, ",", "CollapseDelimiters", false));
    if (numel (cells) != n)
      error ("%s: %s: line %d: expected %d cells, found %d", who, file, numbers(k), n, ...
             numel (cells));
    endif
    row = str2double (cells);
    c = find (! isfinite (row), 1);
    if (! isempty (c))
      error ("%s: %s: line %d, column %d: expected a number, found %s", who, file, numbers(k), ...
             c, cells{c});
    endif
    values(k,:) = row;
  endfor
endfunction
