## par = gs.model.parameter_values (m)
## The values of the parameters of the model M as its module takes them.

function par = parameter_values (m)
  par = cellfun (@double, struct2cell (m.par));
endfunction
