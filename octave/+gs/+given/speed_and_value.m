## pair = gs.given.speed_and_value (who, m, option, name)
## The numbers of the coordinate NAME of the model M and of the speed that is its rate; an error of
## the OPTION of WHO where it has none.

function pair = speed_and_value (who, m, option, name)
  q = find (strcmp (name, m.coordinates));
  if (isempty (q))
    error ("%s: option \"%s\": unknown coordinate %s", who, option,
           gs.text.nearest_word (name, m.coordinates));
  endif
  u = find (strcmp ([name "_d"], m.speeds));
  if (isempty (u) && m.sizes.nq == m.sizes.nu && isempty (m.angles))
    u = q;
  endif
  if (isempty (u))
    error (["%s: option \"%s\": %s has no speed of its own; expected a coordinate of a joint " ...
            "whose speeds are rates of coordinates"], who, option, name);
  endif
  pair = [q, u];
endfunction
