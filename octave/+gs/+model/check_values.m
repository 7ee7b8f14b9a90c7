## gs.model.check_values (m)
## Check the parameters m.par by the rules of the scene: an error where they break one, a warning
## for each value that should not be negative.

function check_values (m)
  par = gs.model.parameter_values (m);
  [reason, negative] = gs.model.checked_values (m, par, fieldnames (m.par));
  if (! isempty (reason{1}))
    error ("gsmbp_set: %s: %s", m.name, reason{1});
  endif
  cellfun (@(text) warning ("gsmbp:negative", "gsmbp_set: %s: %s", m.name, text), negative);
endfunction
