## gs.given.check_parameter (who, m, name)
## An error of WHO where NAME is no parameter of the model M that can be set.

function check_parameter (who, m, name)
  if (isfield (m.par, name))
    return;
  endif
  made_of_others (who, m, name);
  error (["%s: %s: unknown parameter %s (a number that an element of the scene was " ...
          "given is fixed in the code: name it in parameters to change it)"], who, m.name,
         gs.text.nearest_word (name, fieldnames (m.par)'));
endfunction

## an error for a parameter that the scene makes of others
function made_of_others (who, m, name)
  if (! isfield (m.json, "dependent") || isempty (m.json.dependent))
    return;
  endif
  k = find (strcmp (name, {m.json.dependent.name}), 1);
  if (! isempty (k))
    error ("%s: %s: parameter %s is made of others, %s: expected one of these", who, m.name, ...
           name, m.json.dependent(k).expression);
  endif
endfunction
