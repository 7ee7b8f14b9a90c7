## [pp, planned] = gs.given.given_motion (who, m, motion)
## Checks a planned motion: PLANNED are the numbers of the coordinates that its
## components mean, the actuated ones of the scene or all of an open chain.

function [pp, planned] = given_motion (who, m, motion)
  gs.given.check_moving (who, m);
  pp = gs.given.given_polynomial (who, motion);
  n = prod (pp.dim);
  if (n == m.sizes.nu && (m.sizes.nlam == 0 || n == numel (m.actuated)))
    planned = (1:n)';
  elseif (n == numel (m.actuated) && m.sizes.nlam > 0)
    planned = m.actuated;
  else
    wanted = m.actuated;
    if (m.sizes.nlam == 0)   # what no device drives moves as well: it must be planned
      wanted = 1:m.sizes.nu;
    endif
    if (isempty (wanted))
      error (["%s: the planned motion of %s: expected drives or motors, whose joints it moves; " ...
              "found none in this closed chain; add drive(NAME, joint = JOINT) to the scene"], ...
             who, m.name);
    endif
    error ("%s: the planned motion of %s: expected %d components (%s), found %d", who, m.name, ...
           numel (wanted), strjoin (m.coordinates(wanted)', ", "), n);
  endif
endfunction
