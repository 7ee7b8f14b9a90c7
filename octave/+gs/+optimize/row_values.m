## e = gs.optimize.row_values (P, p, wanted, by)
## What the goals and demands of the mask WANTED (goals first) of a design read at the values P of
## its free variables, with derivatives by those of the mask BY, as the engine takes it
## (glue/design.h): times, a row for each load case: t, w and their derivatives; series, a row for
## each load case of each goal and demand: numbers and their derivatives, columns by the variables;
## rough (mask of differences), functions (those of functions are differences).

function e = row_values (P, p, wanted, by)
  list = P.rows;
  e = struct ("times", {repmat({1, 1, [], []}, numel (P.cases), 1)}, "series", {cell(0, 2)}, ...
              "rough", false (size (by)), "functions", false);
  [results, slopes] = deal (struct ());
  for k = cases_of (P, list(wanted))
    c = P.cases(k);
    [R, D, rough] = gs.optimize.run_case (P, c, p, by);
    [results.(c.name), slopes.(c.name)] = deal (R, D);
    e.rough |= rough;
    e.times(k,:) = {R.t(:), R.w(:), moved(D, "t", R, numel (p)), moved(D, "w", R, numel (p))};
  endfor
  for k = 1:numel (list)
    [more, rough] = numbers (P, list(k), wanted(k), results, slopes, p, by, k <= numel (P.goal));
    e.series = [e.series; more];
    e.functions |= rough;
  endfor
endfunction

## the load cases that rows read: functions may read them all
function k = cases_of (P, list)
  k = unique ([list(! ismember ({list.word}, {"value", "mass"}) ...
                    & cellfun(@isempty, {list.f})).cases]);
  if (any (! cellfun (@isempty, {list.f})))
    k = 1:numel (P.cases);
  endif
  k = k(:)';
endfunction

function X = moved (D, name, R, n)
  X = [];
  if (isfield (D, name))
    X = reshape (D.(name), numel (R.t), n);
  endif
endfunction

## the series of a row
function [series, rough] = numbers (P, row, wanted, results, slopes, p, by, goal)
  rough = false;
  if (! isempty (row.f) || any (strcmp (row.word, {"value", "mass"})))
    series = cell (1, 2);
    if (wanted)
      [f, F, rough] = single (P, row, results, p, by);
      if (goal && numel (f) != 1)
        error ("%s: goal %s: expected one number, found %d", P.who, row.text, numel (f));
      endif
      series = {f, F};
    endif
    return;
  endif
  series = cell (numel (row.cases), 2);
  for k = 1:numel (row.cases) * wanted
    c = P.cases(row.cases(k));
    [series{k,:}] = gs.optimize.case_series (P, c, results.(c.name), slopes.(c.name), row.name);
  endfor
endfunction

## what needs no load case by itself: a function, a value, the mass of links
function [f, F, rough] = single (P, row, results, p, by)
  rough = false;
  if (! isempty (row.f))
    [f, F, rough] = gs.optimize.user_function (P, row, results, p, by);
  elseif (strcmp (row.word, "value"))
    [f, F] = value (P, row.name, p);
  else
    [f, slopes] = gs.optimize.total_mass (P.who, gs.optimize.design_model (P, p), row.name);
    F = zeros (1, numel (P.free));
    for k = find (strcmp ({P.free.kind}, "parameter"))
      if (isfield (slopes, P.free(k).name))
        F(k) = slopes.(P.free(k).name);
      endif
    endfor
  endif
endfunction

## a free variable, or a parameter
function [f, F] = value (P, name, p)
  k = strcmp ({P.free.name}, name);
  F = double (k);
  par = P.base.par;
  if (any (k))
    f = p(k);
  elseif (isfield (par, name))
    f = par.(name);
  else
    error ("%s: value: expected a free variable or a parameter, found %s", P.who, ...
           gs.text.nearest_word (name, [{P.free.name}, fieldnames(par)']));
  endif
endfunction
