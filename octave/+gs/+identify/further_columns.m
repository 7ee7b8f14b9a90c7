## w = gs.identify.further_columns (who, m, d, w, o)
## The regression W with the columns that the options O ask for: dry and viscous friction, rotors,
## offsets, one for each coordinate named; w.kind: "base" or the word.

function w = further_columns (who, m, d, w, o)
  n = m.sizes.nu;
  w.kind = repmat ({"base"}, 1, columns (w.Y));
  angle = ! strncmp (m.units.coordinates, "m", 1);
  unit = @(k, word) {sprintf("N%s", word), sprintf("N*m%s", word)}{1 + angle(k)};
  table = {"coulomb", @(k) sign(d.u(:,k)), @(k) unit(k, "")
           "viscous", @(k) d.u(:,k), @(k) {"N*s/m", "N*m*s/rad"}{1 + angle(k)}
           "rotor", @(k) d.ud(:,k), @(k) {"kg", "kg*m^2"}{1 + angle(k)}
           "offset", @(k) ones(numel (d.t), 1), @(k) unit(k, "")};
  for row = table'
    [word, column, of_unit] = row{:};
    for k = coordinates_of (who, m, word, o.(word))
      w.Y(k:n:end,end+1) = column (k);
      w.names{end+1} = [m.coordinates{k} "_" word];
      w.units{end+1} = of_unit (k);
      w.kind{end+1} = word;
      w.p(end+1,1) = 0;
    endfor
  endfor
endfunction

## the coordinates that an option names: all where it is true
function list = coordinates_of (who, m, word, given)
  list = 1:m.sizes.nu;
  if (islogical (given) || isempty (given) || isequal (given, 0) || isequal (given, 1))
    if (isempty (given) || ! given)
      list = [];
    endif
    return;
  endif
  if (! (ischar (given) || iscellstr (given)))
    error ("%s: option %s: expected true or names of coordinates, found %s", who, word, ...
           gs.text.shown_value (given));
  endif
  list = [];
  for name = cellstr (given)(:)'
    k = find (strcmp (m.coordinates, name{1}));
    if (isempty (k))
      error ("%s: option %s: unknown coordinate %s", who, word, ...
             gs.text.nearest_word (name{1}, m.coordinates(:)'));
    endif
    list(end+1) = k;
  endfor
endfunction
