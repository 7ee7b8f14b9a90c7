## panels = gs.model.named_panels (who, m, r, names)
## The named quantities of a result as panels of gsmbp_plot, one for each unit, in the order of the
## names; `heads` are the column heads of a table, with units, `factor` what brings the numbers
## to the unit of the axis; `style` draws what is held between its jumps in steps.

function panels = named_panels (who, m, r, names)
  t = gs.model.name_table (m);
  if (! (isstruct (r) && isscalar (r) && all (isfield (r, {"t", "of"}))))
    error (["%s: argument result: expected a result of gsmbp_simulate or gsmbp_inverse, " ...
            "found %s"], who, gs.text.shown_value (r));
  endif
  names = cellstr (names)(:)';
  rows = t(1:0);
  for name = names
    if (! isfield (r.of, name{1}))
      error ("%s: %s has no %s", who, m.name, gs.text.nearest_word (name{1}, fieldnames (r.of)));
    endif
    rows(end+1) = t(strcmp ({t.name}, name{1}));
  endfor
  held = m.inputs(setdiff (1:m.sizes.nv, gs.model.free_inputs (m)));
  panels = {};
  for unit = unique ({rows.unit}, "stable")
    these = rows(strcmp ({rows.unit}, unit{1}));
    y = cell2mat (cellfun (@(n) r.of.(n), {these.name}, "UniformOutput", false));
    [label, factor] = gs.text.axis_label (unit{1}, y, these);
    heads = cellfun (@(n) head (n, unit{1}), {these.name}, "UniformOutput", false);
    style = {"lines", "fsteps"}(1 + ismember ({these.name}, held));
    panels{end+1} = struct ("y", y, "names", {{these.name}}, "label", label, "heads", {heads}, ...
                            "factor", factor, "style", {style});
  endfor
endfunction

function text = head (name, unit)
  text = name;
  if (! isempty (unit))
    text = sprintf ("%s [%s]", name, unit);
  endif
endfunction
