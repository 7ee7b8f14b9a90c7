## c = gs.sweep.corner_values (w, table, values)
## The worst cases of a sweep W over the corners of TABLE, the parameters: for each column of
## VALUES, what is kept, a struct with name, largest, at_largest, least, at_least, failed.

function c = corner_values (w, table, values)
  k = columns (table);
  high = table > (max (table, [], 1) + min (table, [], 1)) / 2;
  word = @(i) strjoin (cellfun (@(name, h) [name " " {"low", "high"}{1 + h}], w.names(1:k), ...
                                num2cell (high(i,:)), "UniformOutput", false), ", ");
  failed = arrayfun (word, find (! w.ok)', "UniformOutput", false);
  c = struct ("name", w.names(k+1:end), "largest", NaN, "at_largest", "", "least", NaN, ...
              "at_least", "", "failed", {{}});
  [c.failed] = deal (failed);
  for j = find (any (! isnan (values(w.ok,:)), 1))
    [c(j).largest, i] = max (values(:,j));
    c(j).at_largest = word (i);
    [c(j).least, i] = min (values(:,j));
    c(j).at_least = word (i);
  endfor
endfunction
