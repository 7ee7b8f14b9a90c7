## unique = gs.model.unique_routines (m)
## Which multipliers and outputs of the model M the motion determines, as the JSON says
## (in general positions): a struct of two logical rows.  What is not unique is one of
## many values that rigid bodies allow.

function unique = unique_routines (m)
  unique = struct ("multipliers", true (1, m.sizes.nlam), "outputs", true (1, m.sizes.ny));
  rows = gs.model.json_rows (m.json, "multipliers");
  if (numel (rows) == m.sizes.nlam && m.sizes.nlam > 0 && isfield (rows{1}, "unique"))
    unique.multipliers = cellfun (@(row) logical (row.unique), rows);
  endif
  bad = cell (1, 0);
  if (isfield (m.json, "indeterminate_outputs") && ! isempty (m.json.indeterminate_outputs))
    bad = cellstr (m.json.indeterminate_outputs)(:)';
  endif
  unique.outputs(ismember (m.outputs(:)', bad)) = false;
endfunction
