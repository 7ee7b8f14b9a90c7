## modes = gs.events.given_modes (who, m, modes)
## The option modes of a run of the model M.

function modes = given_modes (who, m, modes)
  n = numel (m.events);
  if (n == 0 && ! isempty (modes))
    error ("%s: option modes: %s has no events", who, m.name);
  endif
  if (! (isnumeric (modes) && any (numel (modes) == [0, n]) ...
           && all (any (modes(:) == [-1, 0, 1], 2))))
    error ("%s: option modes: expected %d numbers, each -1, 0 or 1, found %s", who, n, ...
           gs.text.shown_value (modes));
  endif
  modes = double (modes(:)');
endfunction
