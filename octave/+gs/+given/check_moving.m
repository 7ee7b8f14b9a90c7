## gs.given.check_moving (who, m): an error where the scene of the model has no coordinates.

function check_moving (who, m)
  if (m.sizes.nq == 0)
    error ("%s: expected a scene with coordinates; in %s nothing moves", who, m.name);
  endif
endfunction
