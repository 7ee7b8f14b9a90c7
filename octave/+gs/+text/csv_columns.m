## [heads, values, units] = gs.text.csv_columns (who, file)
## A table of numbers between commas: the heads of its columns without their units, the numbers, the
## units that stand in brackets behind the heads ("" where there are none).

function [heads, values, units] = csv_columns (who, file)
  [lines, numbers] = gs.text.csv_lines (who, file);
  if (numel (numbers) < 2)
    error ("%s: %s: expected a line of heads and lines of numbers, found %d lines", who, file, ...
           numel (numbers));
  endif
  [heads, units] = gs.text.csv_heads (lines{1});
  others = {";", "semicolons"; "\t", "tabs"};
  other = others(cellfun (@(c) any (lines{1} == c), others(:,1)),2);
  if (isscalar (heads) && ! isempty (other))
    error (["%s: %s: line %d: expected commas between the columns (and points in decimals), " ...
            "found %s"], who, file, numbers(1), other{1});
  endif
  for c = 2:numel (heads)
    if (any (strcmp (heads(1:c-1), heads{c})))
      error ("%s: %s: the head %s is there twice", who, file, heads{c});
    endif
  endfor
  values = numbers_of (who, file, lines(2:end), numbers(2:end), numel (heads));
endfunction

function values = numbers_of (who, file, lines, numbers, n)
  values = zeros (numel (numbers), n);
  for k = 1:numel (numbers)
    [row, count, message] = sscanf (lines{k}, "%f,", [1, Inf]);
    if (numel (row) == n && sum (lines{k} == ",") == n - 1 && all (isfinite (row)))
      values(k,:) = row;
      continue;
    endif
    cells = strtrim (strsplit (lines{k}, ",", "CollapseDelimiters", false));
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
