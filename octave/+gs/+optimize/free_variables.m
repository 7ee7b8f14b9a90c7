## free = gs.optimize.free_variables (who, m, rows)
## What a design may change, a struct array: name, kind (parameter of the model M, state: its start,
## own: of the user's functions), start, low, high, list (of choices; [] where it is continuous).
## ROWS: a cell array, a row {name, start, [low, high]} or {name, start, {a, b, ...}} each.

function free = free_variables (who, m, rows_)
  if (! (iscell (rows_) && columns (rows_) == 3 && rows (rows_) > 0))
    error (["%s: argument free: expected a cell array with a row {name, start, [low, high]} " ...
            "for each variable, found %s"], who, gs.text.shown_value (rows_));
  endif
  for k = rows (rows_):-1:1
    free(k) = one (who, m, rows_{k,:});
  endfor
  [~, first] = unique ({free.name}, "first");
  twice = setdiff (1:numel (free), first);
  if (! isempty (twice))
    error ("%s: argument free: %s is given twice", who, free(twice(1)).name);
  endif
  free = free(:)';
endfunction

function f = one (who, m, name, start, bounds)
  if (! (ischar (name) && rows (name) == 1))
    error ("%s: argument free: expected the name of a variable, found %s", who, ...
           gs.text.shown_value (name));
  endif
  what = sprintf ("argument free: %s", name);
  gs.given.check_kind (who, [what ": start"], start, "number");
  f = struct ("name", name, "kind", kind (who, m, name), "start", double (start), ...
              "low", -Inf, "high", Inf, "list", []);
  if (iscell (bounds))
    if (strcmp (f.kind, "state"))
      error ("%s: %s: a start of a state cannot be chosen from a list", who, what);
    endif
    f.list = choices (who, what, bounds);
    [f.low, f.high] = deal (min (f.list), max (f.list));
  else
    [f.low, f.high] = range (who, what, bounds);
  endif
  if (! (start >= f.low && start <= f.high))
    error ("%s: %s: expected a start from %g to %g, found %g", who, what, f.low, f.high, start);
  endif
endfunction

function text = kind (who, m, name)
  text = "own";
  if (isfield (m.par, name))
    text = "parameter";
  elseif (any (strcmp (m.states, name)))
    text = "state";
  elseif (isfield (m.json, "dependent") && ! isempty (m.json.dependent) ...
          && any (strcmp ({m.json.dependent.name}, name)))
    k = strcmp ({m.json.dependent.name}, name);
    error ("%s: argument free: %s is made of others, %s: expected one of these", who, name, ...
           m.json.dependent(k).expression);
  elseif (! isvarname (name))
    error ("%s: argument free: unknown name %s", who, ...
           gs.text.nearest_word (name, [fieldnames(m.par); m.states(:)]'));
  endif
endfunction

function list = choices (who, what, cells)
  good = @(c) isnumeric (c) && isreal (c) && isscalar (c) && isfinite (c);
  if (isempty (cells) || ! all (cellfun (good, cells(:))))
    error ("%s: %s: expected a list of finite numbers to choose from, found %s", who, what, ...
           gs.text.shown_value (cells));
  endif
  list = unique (double ([cells{:}]));
endfunction

function [low, high] = range (who, what, bounds)
  if (! (isnumeric (bounds) && isreal (bounds) && numel (bounds) == 2 && bounds(1) < bounds(2)))
    error (["%s: %s: expected bounds [low, high], the first below the second " ...
            "(-Inf, Inf: none), or a list {a, b, ...}, found %s"], who, what, ...
                gs.text.shown_value (bounds));
  endif
  [low, high] = deal (double (bounds(1)), double (bounds(2)));
endfunction
