## w = gs.identify.regression_rows (who, m, d, o)
## The whole regression of the data D: Y*p = b with the further columns and motors of the options O,
## the group of each row (effort or voltage), what was measured.

function w = regression_rows (who, m, d, o)
  n = m.sizes.nu;
  w = gs.identify.plain_rows (who, m, d);
  measured = d.tau';
  w.b = measured(:) - w.r;
  w.group = repmat ((1:n)', numel (d.t), 1);
  w = gs.identify.further_columns (who, m, d, w, o);
  w = gs.identify.motor_rows (who, m, d, w, o.motors);
  w.measured = w.b;
  at = 1:n*numel (d.t);
  w.measured(at) += w.r;
endfunction
