## e = gs.optimize.assess_values (P, z)
## Goal and demands of a design at Z, the continuous free variables beside their scales, and a
## number above (or below) each peak that is a goal: J, gJ; g, A with low, high, row (the demand of
## each, 0: of a peak); H, the Gauss-Newton matrix of goals that are squares; results by the names
## of the load cases.

function e = assess_values (P, z)
  n = numel (P.free);
  scale = reshape ([P.free.scale], [], 1);
  p = z(1:n) .* scale;
  e = struct ("J", 0, "gJ", zeros (numel (z), 1), "g", zeros (0, 1), "A", zeros (0, numel (z)), ...
              "low", zeros (0, 1), "high", zeros (0, 1), "row", zeros (0, 1), ...
              "H", zeros (numel (z)), "results", struct (), "p", p, "rough", false (1, n), ...
              "functions", false);
  D = struct ();
  for c = P.cases(P.used)
    [e.results.(c.name), D.(c.name), rough] = gs.optimize.run_case (P, c, p);
    e.rough |= rough;
  endfor
  s = n;
  for row = P.goal
    if (row.above)
      s++;
      e.J += row.factor * z(s) * P.sizes(s-n);
      e.gJ(s) += row.factor * P.sizes(s-n);
      e = below (P, e, D, row, s, z(s) * P.sizes(s-n), P.sizes(s-n));
      continue;
    endif
    [e, f, F, H] = total (P, e, D, row, p);
    e.J += row.factor * f;
    e.gJ(1:n) += row.factor * F';
    e.H(1:n,1:n) += row.factor * H;
  endfor
  for k = 1:numel (P.demands)
    e = demanded (P, e, D, k, p);
  endfor
  e.gJ(1:n) .*= scale;
  e.H(1:n,1:n) .*= scale * scale';
  e.A(:,1:n) .*= scale';
endfunction

## a goal over its load cases, by the values themselves
function [e, f, F, H] = total (P, e, D, row, p)
  n = numel (P.free);
  H = zeros (n);
  if (! isempty (row.f))
    [f, F, rough] = gs.optimize.user_function (P, row, e.results, p);
    e.functions |= rough;
    if (numel (f) != 1)
      error ("%s: goal %s: expected one number, found %d", P.who, row.text, numel (f));
    endif
    return;
  elseif (any (strcmp (row.word, {"value", "mass"})))
    [f, F] = still (P, row, p);
    return;
  endif
  [f, F] = deal (0, zeros (1, n));
  for c = P.cases(row.cases)
    [y, Y] = gs.optimize.case_series (P, c, e.results.(c.name), D.(c.name), row.name);
    R = e.results.(c.name);
    [one, slope] = gs.optimize.measure_word (row.word, y, Y, R, D.(c.name), c.band);
    f += one;
    F += slope;
    if (strcmp (row.word, "square"))
      H += 2 * Y' * (R.w(:) .* Y) / sum (R.w);
    endif
  endfor
endfunction

## the number S is above all values of a peak (below, if the goal is to make it large)
function e = below (P, e, D, row, s, at, size_)
  n = numel (P.free);
  for c = P.cases(row.cases)
    [y, Y] = gs.optimize.case_series (P, c, e.results.(c.name), D.(c.name), row.name);
    sides = {"peak", [1, -1]; "max", 1; "min", -1};
    sides = sides{strcmp (sides(:,1), row.word),2};
    for side = sides
      of = merge (strcmp (row.word, "min"), -1, 1);
      A = zeros (numel (y), columns (e.A));
      A(:,1:n) = side * Y;
      A(:,s) = -of * size_;
      e = more (e, side * y - of * at, A, -Inf, 0, 0);
    endfor
  endfor
endfunction

function e = more (e, g, A, low, high, row)
  k = numel (g);
  e.g = [e.g; g];
  e.A = [e.A; A];
  e.low = [e.low; repmat(low, k, 1)];
  e.high = [e.high; repmat(high, k, 1)];
  e.row = [e.row; repmat(row, k, 1)];
endfunction

function e = demanded (P, e, D, k, p)
  n = numel (P.free);
  row = P.demands(k);
  widened = @(F) [F, zeros(rows (F), columns (e.A) - n)];
  range = struct ("lt", [-Inf, row.bound], "gt", [row.bound, Inf], "eq", row.bound * [1, 1]);
  range = range.(struct ("a", "lt", "b", "gt", "c", "eq").("abc"(row.relation == "<>=")));
  if (! isempty (row.f) || any (strcmp (row.word, {"value", "mass"})))
    if (isempty (row.f))
      [f, F] = still (P, row, p);
    else
      [f, F, rough] = gs.optimize.user_function (P, row, e.results, p);
      e.functions |= rough;
    endif
    e = more (e, f, widened (F), range(1), range(2), k);
    return;
  endif
  for c = P.cases(row.cases)
    R = e.results.(c.name);
    [y, Y] = gs.optimize.case_series (P, c, R, D.(c.name), row.name);
    word = row.word;
    if (any (strcmp ([word row.relation], {"peak<", "max<", "min>"})))
      if (strcmp (word, "peak"))
        range(1) = -row.bound;
      endif
      word = "each";
    endif
    [f, F] = gs.optimize.measure_word (word, y, Y, R, D.(c.name), c.band);
    e = more (e, f, widened (F), range(1), range(2), k);
  endfor
endfunction

## what needs no load case: a value, or the mass of links
function [f, F] = still (P, row, p)
  if (strcmp (row.word, "value"))
    [f, F] = value (P, row.name, p);
    return;
  endif
  [f, slopes] = gs.optimize.total_mass (P.who, P.model (p), row.name);
  F = zeros (1, numel (P.free));
  for k = find (strcmp ({P.free.kind}, "parameter"))
    if (isfield (slopes, P.free(k).name))
      F(k) = slopes.(P.free(k).name);
    endif
  endfor
endfunction

## a free variable, or a parameter
function [f, F] = value (P, name, p)
  k = strcmp ({P.free.name}, name);
  F = double (k);
  par = P.base.par;
  if (any (k))
    f = p(k);
  elseif (isfield (P.given, name))
    f = P.given.(name);
  elseif (isfield (par, name))
    f = par.(name);
  else
    error ("%s: value: expected a free variable or a parameter, found %s", P.who, ...
           gs.text.nearest_word (name, [{P.free.name}, fieldnames(par)']));
  endif
endfunction
