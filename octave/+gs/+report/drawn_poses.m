## [number, place, turn] = gs.report.drawn_poses (who, drawing, m, r, list)
## What is drawn (gsmbp/show/drawing.mac) along the rows LIST of a run R: NUMBER, a handle that
## gives the values of a cell array of expressions, a row for each instant; PLACE and TURN, cell
## arrays by body: nt x 3 [m], and nt x 9, the rotation by rows, in ground axes.

function [number, place, turn] = drawn_poses (who, drawing, m, r, list)
  v = zeros (numel (list), numel (m.inputs));
  if (isfield (r, "v") && columns (r.v) == columns (v))
    v = r.v(list,:);
  endif
  named = {};
  if (! isempty (drawing.parameters))
    named = cellstr (drawing.parameters)(:)';
  endif
  p = cellfun (@(name) m.par.(name), named);
  [t, x] = deal (r.t(:)(list), r.x(list,:));
  z = zeros (numel (list), numel (drawing.program));
  for k = 1:columns (z)
    parts = strsplit (drawing.program{k}, " = ");
    if (! strcmp (parts{1}, sprintf ("z%d", k)))
      error ("%s: the page of Maxima: expected a statement of z%d, found: %s", who, k, ...
             drawing.program{k});
    endif
    z(:,k) = value (who, parts{2}, t, x, v, p, z);
  endfor
  number = @(texts) numbers (who, texts, t, x, v, p, z);
  place = turn = cell (1, numel (drawing.bodies));
  for b = 1:numel (drawing.bodies)
    place{b} = number (drawing.bodies(b).place);
    turn{b} = number (drawing.bodies(b).turn);
  endfor
endfunction

function y = numbers (who, texts, t, x, v, p, z)
  texts = cellstr (texts)(:)';
  y = zeros (numel (t), numel (texts));
  for k = 1:numel (texts)
    y(:,k) = value (who, texts{k}, t, x, v, p, z);
  endfor
endfunction

## one expression; what is not arithmetic of the symbols of a drawing is not evaluated
function y = value (who, text, t, x, v, p, z)
  number = str2double (text);
  if (! isnan (number))
    y = number;
    return;
  endif
  words = unique (regexp (text, '[A-Za-z_]\w*', "match"));
  known = {"t", "pi", "e", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", ...
           "cosh", "tanh", "exp", "log", "sqrt", "abs", "signum", "min", "max"};
  own = ! cellfun (@isempty, regexp (words, '^[xvpz]\d+$', "once"));
  plain = ! isempty (regexp (text, '^[\w+\-*/^()., ]*$', "once"));
  if (! plain || ! all (own | ismember (words, known)))
    error ("%s: the page of Maxima: expected an expression of arithmetic, found: %s", who, text);
  endif
  text = regexprep (text, '\<p(\d+)\>', 'p($1)');
  text = regexprep (text, '\<([xvz])(\d+)\>', '$1(:,$2)');
  text = regexprep (strrep (text, "signum", "sign"), '([*/^])', '.$1');
  y = eval ([text ";"]);
endfunction
