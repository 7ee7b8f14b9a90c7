## [y, Y] = gs.optimize.case_series (P, c, R, D, name)
## A named quantity of a load case, a number for each of its times, and its derivatives by the free
## variables, columns: a name of gsmbp_names, of extra, "error." in front: less its target; or a
## product "a*b".

function [y, Y] = case_series (P, c, R, D, name)
  n = numel (P.free);
  parts = strtrim (strsplit (name, "*"));
  if (numel (parts) > 1)
    [y, Y] = gs.optimize.case_series (P, c, R, D, parts{1});
    for k = 2:numel (parts)
      [b, B] = gs.optimize.case_series (P, c, R, D, parts{k});
      Y = Y .* b + y .* B;
      y .*= b;
    endfor
  elseif (strncmp (name, "error.", 6))
    [y, Y] = gs.optimize.case_series (P, c, R, D, name(7:end));
    y -= target (c, R, name(7:end));
    Y -= moved_target (c, R, D, name(7:end), size (Y));
  elseif (isfield (R.extra, name))
    y = R.extra.(name);
    Y = zeros (1, n);
    if (isfield (D, "extra") && isfield (D.extra, name))
      Y = reshape (D.extra.(name), 1, n);
    endif
    [y, Y] = deal (repmat (y, numel (R.t), 1), repmat (Y, numel (R.t), 1));
  elseif (! isempty (regexp (name, '^state_margin\d+$', "once")))
    k = str2double (name(13:end));
    if (! isfield (R, "state_margins") || k < 1 || k > columns (R.state_margins))
      error ("%s: case %s: %s: expected the number of a margin (m.state_margins), 1 to %d", ...
             P.who, ...
             c.name, name, numel (P.base.state_margins));
    endif
    y = R.state_margins(:,k);
    Y = zeros (numel (y), n);
    if (isfield (D, "state_margins"))
      Y = reshape (D.state_margins(:,k,:), numel (y), n);
    endif
  else
    row = P.table(strcmp ({P.table.name}, name));
    if (! isempty (regexp (name, '^(frequency|damping)\d+$', "once")))
      error ("%s: case %s: %s: found %d oscillations about the equilibrium", P.who, c.name, ...
             name, ...
             sum (strncmp (fieldnames (R.extra), "freq", 4)));
    elseif (isempty (row))
      error ("%s: case %s: unknown quantity %s", P.who, c.name, ...
             gs.text.nearest_word (name, [{P.table.name}, fieldnames(R.extra)', P.also]));
    elseif (! isfield (R, row.field) || columns (R.(row.field)) < row.column)
      error ("%s: case %s (%s): there is no %s in its result", P.who, c.name, c.kind, name);
    endif
    y = R.(row.field)(:,row.column);
    Y = zeros (numel (y), n);
    if (isfield (D, row.field))
      Y = reshape (D.(row.field)(:,row.column,:), numel (y), n);
    endif
  endif
  if (! all (isfinite (y)))
    error ("%s: case %s: %s is not known (NaN)", P.who, c.name, name);
  endif
endfunction

## how the target of a quantity changes where an event moves the last time
function Y = moved_target (c, R, D, name, sizes)
  Y = zeros (sizes);
  given = c.target.(name);
  if (! isfield (D, "t") || ! any (D.t(:)) || isnumeric (given))
    return;
  endif
  h = 1e-3 * (R.t(end) - R.t(1));
  at = @(s) target (c, struct ("t", R.t + s * h), name);
  Y = (8 * (at (1) - at (-1)) - (at (2) - at (-2))) / (12 * h) .* reshape (D.t, sizes);
endfunction

## what a quantity should be: one number, one for each time, a piecewise polynomial or a function of
## the time
function v = target (c, R, name)
  if (! isfield (c.target, name))
    error (["gsmbp_optimize: case %s: error.%s needs what %s should be: option \"target\", " ...
            "struct (\"%s\", ...)"], c.name, name, name, name);
  endif
  v = c.target.(name);
  if (is_function_handle (v))
    v = v(R.t);
  elseif (isstruct (v))
    v = ppval (v, R.t);
  endif
  if (! (isnumeric (v) && any (numel (v) == [1, numel(R.t)]) && all (isfinite (v(:)))))
    error ("gsmbp_optimize: case %s: target of %s: expected 1 or %d finite numbers, found %s", ...
           c.name, name, numel (R.t), gs.text.shown_value (v));
  endif
  v = v(:);
endfunction
