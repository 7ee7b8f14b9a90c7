## [f, slopes] = gs.optimize.total_mass (who, m, name)
## The mass of links of the model M [kg]: NAME is "all", or links ("arm, fore"); SLOPES: its
## derivatives, a struct by the names of the parameters that it is made of.

function [f, slopes] = total_mass (who, m, name)
  if (! isfield (m.json, "masses"))
    error ("%s: mass: %s was derived without the masses of its links: derive it again", who, ...
           m.name);
  endif
  list = gs.model.json_rows (m.json, "masses");
  known = cellfun (@(row) row.link, list, "UniformOutput", false);
  chosen = 1:numel (known);
  if (! strcmp (name, "all"))
    chosen = numbers (who, name, known);
  endif
  [values, slopes_of] = masses (who, m, list);
  f = sum (values(chosen));
  slopes = struct ();
  for k = chosen(:)'
    names = cellstr (list{k}.parameters);
    for i = 1:numel (slopes_of{k})
      if (! isfield (slopes, names{i}))
        slopes.(names{i}) = 0;
      endif
      slopes.(names{i}) += slopes_of{k}(i);
    endfor
  endfor
endfunction

## the mass of each link, its derivatives by the parameters that it is made of
function [values, slopes] = masses (who, m, list)
  n = cellfun (@(row) numel (row.parameters), list);
  if (any (n) && ! any (strcmp (m.subroutines, "ini")))
    error ("%s: mass: %s was derived without the masses of its links: derive it again", who, ...
           m.name);
  endif
  values = cellfun (@(row) row.value, list)(:);
  slopes = repmat ({zeros(0, 1)}, size (list));
  if (any (n))
    [~, values, all] = gs.model.made_values (m);
    slopes = mat2cell (all(:), n, 1);
  endif
endfunction

function k = numbers (who, name, known)
  names = strtrim (strsplit (name, ","));
  [there, k] = ismember (names, known);
  if (! all (there))
    error ("%s: mass: unknown link %s", who, gs.text.nearest_word (names{find (! there, 1)}, ...
           [known(:)', "all"]));
  elseif (numel (unique (k)) < numel (k))
    error ("%s: mass: expected every link once, found %s", who, name);
  endif
endfunction
