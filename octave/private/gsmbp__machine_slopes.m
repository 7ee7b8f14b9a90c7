## slopes = gsmbp__machine_slopes (d, names)
## Derivatives of the series of all measures of the design D by the parameters NAMES (columns),
## for a change by their own value, a cell each: central differences of runs of the machine
## without rounding.

function slopes = gsmbp__machine_slopes (d, names)
  d.machine = d.smooth;
  h = 1e-3;
  at = @(name, x) {gsmbp__machine_proof(d, struct (name, x)).measures.series};
  slopes = cell (1, numel (d.proof.measures));
  for k = 1:numel (names)
    [above, below] = deal (at (names{k}, 1 + h), at (names{k}, 1 - h));
    for i = 1:numel (slopes)
      slopes{i}(:,k) = (above{i} - below{i}) / (2 * h);
    endfor
  endfor
endfunction
