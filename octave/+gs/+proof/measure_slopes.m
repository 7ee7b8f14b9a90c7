## [slopes, said] = gs.proof.measure_slopes (d, names)
## Derivatives of the series of all measures of the design D by the parameters NAMES (columns),
## for a change by their own value, a cell each, of the machine without converters; SAID: how.
## Where the scene was derived for these parameters the derivatives of states and voltages are
## carried with the runs; else they, and what follows from them, are central differences.

function [slopes, said] = measure_slopes (d, names)
  d.machine = d.smooth;
  known = isfield (d.model.json, "sensitivity") && any (strcmp (d.machine.subroutines, "ctd"));
  if (known && all (ismember (names, cellstr (d.model.json.sensitivity))))
    runs = gs.proof.carried_runs (d, names);
    said = ["carried with the runs, without converters; what loads the gears alone, by " ...
            "differences"];
    at = @(k, h) moved (d, runs, names{k}, k, h);
  else
    said = "central differences of runs without converters";
    at = @(k, h) gs.proof.prove_at (d, struct (names{k}, 1 + h));
  endif
  h = 1e-3;
  slopes = cell (1, numel (d.proof.measures));
  for k = 1:numel (names)
    [above, below] = deal ({at(k, h).measures.series}, {at(k, -h).measures.series});
    for i = 1:numel (slopes)
      slopes{i}(:,k) = (above{i} - below{i}) / (2 * h);
    endfor
  endfor
endfunction

## what is found where states and voltages are moved along their derivatives
function p = moved (d, runs, name, k, h)
  [m, ~, own] = gs.proof.model_at (d, struct (name, 1 + h));
  for i = 1:numel (runs)
    r = runs{i};
    r.x += h * r.slopes(:,:,k);
    r.v(:,[d.axes.input]) += h * r.voltage_slopes(:,:,k);
    r.error = r.x(:,[d.axes.k]) - r.planned;
    p.runs{i} = r;
  endfor
  p.cycles = gs.drive.load_cycles (m, d.axes, own);
  p.measures = gs.proof.list_measures (d, m, p);
endfunction
