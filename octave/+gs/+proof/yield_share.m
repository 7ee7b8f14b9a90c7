## d = gs.proof.yield_share (d)
## The yield of the design D: its machine runs D.asked.yield times through all tasks with parameters
## off by shares within the tolerances, all as likely (Sobol points).  Adds yield: runs, met (how
## many keep all limits), share, between (a 95 % interval of it, Wilson's), and by measure, in the
## order of the margins, measures: met, share, worst.

function d = yield_share (d)
  d.yield = [];
  n = d.asked.yield;
  if (! d.found || n == 0 || isempty (d.asked.tolerances))
    return;
  endif
  [names, shares] = deal (d.asked.tolerances(:,1)', [d.asked.tolerances{:,2}]);
  off = shares .* (2 * gs.sweep.sobol_points ("gsmbp_design", n, numel (names)) - 1);
  used = zeros (n, numel (d.proof.measures));
  for i = 1:n
    p = gs.proof.prove_at (d, cell2struct (num2cell (1 + off(i,:)(:)), names(:), 1));
    used(i,:) = [p.measures.used];
  endfor
  keeps = used <= 1;
  met = sum (all (keeps, 2));
  d.yield = struct ("runs", n, "met", met, "share", met / n, "between", wilson (met, n), ...
                    "measures", struct ("axis", {d.proof.measures.axis}, "name", ...
                                        {d.proof.measures.name}, "met", ...
                                        num2cell (sum (keeps, 1)), "share", ...
                                        num2cell (mean (keeps, 1)), "worst", ...
                                        num2cell (max (used, [], 1))));
endfunction

## the interval of a share of which K of N were counted
function ends = wilson (k, n)
  z = 1.959964;
  middle = (k + z ^ 2 / 2) / (n + z ^ 2);
  half = z / (n + z ^ 2) * sqrt (k * (n - k) / n + z ^ 2 / 4);
  ends = [max(0, middle - half), min(1, middle + half)];
endfunction
