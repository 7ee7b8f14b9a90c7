## memory = gs.run.given_memory (who, m, memory)
## The option memory of a run of the model M, by default that of its sampled devices.

function memory = given_memory (who, m, memory)
  if (isempty (m.controllers))
    if (! (isnumeric (memory) && isempty (memory)))
      error ("%s: option memory: %s has no sampled devices", who, m.name);
    endif
    return;
  endif
  if (isnumeric (memory) && isempty (memory))
    memory = vertcat (m.controllers.starts);
  endif
  nxk = m.sizes.nxk;
  if (! (isnumeric (memory) && numel (memory) == nxk && all (isfinite (memory(:)))))
    error ("%s: option memory: %s", who, ...
           gs.text.refusal_text ("memory", nxk, gs.text.shown_value (memory)));
  endif
  memory = double (memory(:)');
  check_memory (who, m, memory);
endfunction

## what the entries say of a memory that can be
function check_memory (who, m, memory)
  for one = m.controllers
    own = num2cell (memory(1:numel (one.memory)));
    memory(1:numel (one.memory)) = [];
    for rule = gs.model.json_rows (one, "possible")
      letters = sprintf (", p%d", 1:numel (own))(3:end);
      if (str2func (sprintf ("@(%s) %s", letters, rule{1}.value)) (own{:}) < 0)
        pairs = cellfun (@(name, x) sprintf ("%s = %.6g", name, x), one.memory(:)', own, ...
                         "UniformOutput", false);
        error ("%s: option memory: %s: expected %s; found %s", who, one.name, rule{1}.text, ...
               strjoin (pairs, ", "));
      endif
    endfor
  endfor
endfunction
