## d = gs.proof.all_corners (d)
## Margins of the design D under the tolerances of its specification: the derivatives of each
## measure by the parameters, at the time where with them it may become largest, say which
## corner is its worst; the machine runs at all these corners (at all there are of up to three
## parameters). Adds margins (the measures with first: the largest to first order, slope: its
## derivatives there by the share of each parameter, predicted: its corner by them, worst: the
## largest that is found at a corner, corner: which) and corners (a row of structs: signs, +1 or
## -1 for each parameter, and proof).

function d = all_corners (d)
  [names, shares] = deal (d.asked.tolerances(:,1)', [d.asked.tolerances{:,2}]);
  d.corners = struct ("signs", {}, "proof", {});
  d.margins = d.proof.measures;
  for name = {"slope", "first", "predicted", "corner", "worst"}
    [d.margins.(name{1})] = deal ([]);
  endfor
  if (isempty (names) || ! all (isfinite ([d.margins.found])))
    return;
  endif
  [slopes, d.derivatives] = gs.proof.measure_slopes (d, names);
  signs = zeros (0, numel (names));
  for i = 1:numel (d.margins)
    [d.margins(i), both] = extremes (d.margins(i), slopes{i}, shares(:));
    own(i,:) = both(1,:);
    signs = [signs; both];
  endfor
  if (numel (names) < 4)
    signs = gs.proof.corner_signs (numel (names));
  endif
  all_ = unique (signs, "rows");
  [~, which_] = ismember (own, all_, "rows");
  for k = 1:rows (all_)
    factors = cell2struct (num2cell (1 + all_(k,:)(:) .* shares(:)), names(:), 1);
    d.corners(k) = struct ("signs", all_(k,:), "proof", gs.proof.prove_at (d, factors));
  endfor
  if (! d.asked.Ms_corners)
    d.Ms_corners = gs.proof.loops_at (d, all_ .* shares);
  endif
  found = cell2mat (arrayfun (@(c) [c.proof.measures.found]', d.corners, "UniformOutput", false));
  for i = 1:numel (d.margins)
    d.margins(i).predicted = which_(i);
    [d.margins(i).worst, d.margins(i).corner] = max (found(i,:));
  endfor
endfunction

## a measure ONE with its largest to first order, by derivatives S of its series; its corner and,
## where the other sign is within a tenth of it, that of this
function [one, signs] = extremes (one, S, shares)
  y = one.series;
  [high, at] = max (y + abs (S) * shares);
  [low, below] = max (-y + abs (S) * shares);
  ends = {1 - 2 * (S(at,:) < 0), 1 - 2 * (-S(below,:) < 0)};
  slopes = {S(at,:), -S(below,:)};
  [tops, order] = sort ([high, low], "descend");
  [one.first, one.slope] = deal (tops(1), slopes{order(1)});
  signs = ends{order(1)};
  if (tops(2) > 0.9 * tops(1))
    signs = [signs; ends{order(2)}];
  endif
endfunction
