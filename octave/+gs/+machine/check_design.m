## d = gs.machine.check_design (who, m, d)
## The design D with what its specification says of the scene M looked at: as many accuracies as
## axes, names of tolerances and springs that are parameters of the scene.

function d = check_design (who, m, d)
  n = numel (d.axes);
  given = d.asked.accuracy(:)';
  if (! any (numel (given) == [1, n]))
    error ("%s: accuracy: expected 1 or %d numbers (for %s), found %d", who, n, ...
           strjoin ({d.axes.coordinate}, ", "), numel (given));
  endif
  d.asked.accuracy = given .* ones (1, n);
  known = fieldnames (m.par)';
  for part = {"tolerances", "springs"}
    for name = d.asked.(part{1})(:,1)'
      if (! isfield (m.par, name{1}))
        error ("%s: %s: unknown parameter %s", who, part{1}, gs.text.nearest_word (name{1}, known));
      endif
    endfor
  endfor
  for name = d.asked.support(:,1)'
    k = find (strcmp ({d.axes.coordinate}, name{1}));
    if (isempty (k) || ! strcmp (d.axes(k).unit, "m"))
      error ("%s: support: expected coordinates that slide and are driven, found %s", who, name{1});
    endif
  endfor
  chosen = arrayfun (@(a) struct2cell (a.par), d.axes, "UniformOutput", false);
  chosen = vertcat (chosen{:});
  own = chosen(isfield (m.par, chosen));
  [~, first] = unique (own);
  twice = own(setdiff (1:numel (own), first));
  if (! isempty (twice))
    error (["%s: the parameter %s stands for more than one axis, whose choices differ: " ...
            "expected one for each"], who, twice{1});
  endif
  for name = d.asked.tolerances(:,1)'
    if (m.par.(name{1}) == 0 && ! any (strcmp (own, name{1})))
      error ("%s: tolerances: %s is 0, of which there is no share", who, name{1});
    endif
  endfor
endfunction
