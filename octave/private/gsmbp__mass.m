## [f, slopes] = gsmbp__mass (who, m, name)
## The mass of links of the model M [kg]: NAME is "all", or links ("arm, fore"); SLOPES: its
## derivatives, a struct by the names of the parameters that it is made of.

function [f, slopes] = gsmbp__mass (who, m, name)
  if (! isfield (m.json, "masses"))
    error ("%s: mass: %s was derived without the masses of its links: derive it again", who, ...
           m.name);
  endif
  list = gsmbp__rows (m.json, "masses");
  known = cellfun (@(row) row.link, list, "UniformOutput", false);
  chosen = 1:numel (known);
  if (! strcmp (name, "all"))
    chosen = numbers (who, name, known);
  endif
  f = 0;
  slopes = struct ();
  for row = list(chosen)(:)'
    row = row{1};
    f += gsmbp__value (m, row, []);
    names = cellstr (row.parameters);
    texts = cellstr (row.slopes);
    for k = 1:numel (texts) * ! isempty (row.slopes)
      row.value = texts{k};
      if (! isfield (slopes, names{k}))
        slopes.(names{k}) = 0;
      endif
      slopes.(names{k}) += gsmbp__value (m, row, []);
    endfor
  endfor
endfunction

function k = numbers (who, name, known)
  names = strtrim (strsplit (name, ","));
  [there, k] = ismember (names, known);
  if (! all (there))
    error ("%s: mass: unknown link %s", who, gsmbp__unknown (names{find (! there, 1)}, ...
           [known(:)', "all"]));
  elseif (numel (unique (k)) < numel (k))
    error ("%s: mass: expected every link once, found %s", who, name);
  endif
endfunction
