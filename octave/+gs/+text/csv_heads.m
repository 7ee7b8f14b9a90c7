## [heads, units] = gs.text.csv_heads (line)
## The heads of the columns of a table between commas, and the units in brackets behind them ("":
## none).

function [heads, units] = csv_heads (line)
  cells = strtrim (strsplit (line, ",", "CollapseDelimiters", false));
  [heads, units] = deal (cells, cell (size (cells)));
  for c = 1:numel (cells)
    token = regexp (cells{c}, '^([^\[]*?)\s*(?:\[(.*)\])?$', "tokens", "once");
    if (isempty (token))   # brackets that make no unit
      token = cells(c);
    endif
    token(end+1:2) = {""};
    [heads{c}, units{c}] = token{1:2};
  endfor
endfunction
