## z = gs.run.ensemble_values (who, m, x, v, y, name)
## The state, input or output NAME of the model M in pages of runs: a row for each time, a column
## for each run.

function z = ensemble_values (who, m, x, v, y, name)
  names = {m.states, m.inputs, m.outputs};
  pages = {x, v, y};
  for i = 1:3
    k = find (strcmp (names{i}, name), 1);
    if (! isempty (k))
      z = reshape (pages{i}(:,k,:), size (x, 1), size (x, 3));
      return;
    endif
  endfor
  error ("%s: unknown name %s", who, ...
         gs.text.nearest_word (name, [names{1}(:); names{2}(:); names{3}(:)]'));
endfunction
