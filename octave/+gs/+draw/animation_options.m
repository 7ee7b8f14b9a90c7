## o = gs.draw.animation_options (who, o, skeleton, t, named)
## The options O of gsmbp_animate, checked; T: the times of the motion; NAMED: the points of the
## scene, which stand behind those of the skeleton.

function o = animation_options (who, o, skeleton, t, named)
  if (o.fps > 50)
    error (["%s: option fps must be at most 50 (a GIF counts hundredths of a second), " ...
            "found: %g"], who, o.fps);
  endif
  o.delay = round (100 / o.fps);
  if (! (isnumeric (o.view) && numel (o.view) == 2 && all (isfinite (o.view)) && o.view(1) >= 0 ...
           && o.view(1) <= 180))
    error (["%s: option view must be two angles [tilt, turn] in degrees, tilt from 0 to 180, " ...
            "found %s"], who, gs.text.shown_value (o.view));
  endif
  o.view(2) = mod (o.view(2), 360);
  slack = 1e-9 * (1 + abs (t(end)) + abs (t(1)));
  if (! (isnumeric (o.times) && all (o.times(:) >= t(1) - slack) ...
           && all (o.times(:) <= t(end) + slack)))
    error ("%s: option times must lie within the result, from %.9g to %.9g s, found %s", who, ...
           t(1), t(end), gs.text.shown_value (o.times));
  endif
  [o.trace, o.traced] = traced (who, o.trace, skeleton, named);
endfunction

## the column of m.ske that option trace means, and its name
function [column, name] = traced (who, wanted, skeleton, named)
  column = [];
  name = "";
  last = cumsum (skeleton.points);
  if (ischar (wanted) && any (strcmp (wanted, named)))
    column = last(end) + numel ([skeleton.parts.bodies]) + find (strcmp (wanted, named));
    name = ["path of " wanted];
    return;
  endif
  if (ischar (wanted) && ! isempty (wanted))
    k = find (strcmp (skeleton.body, wanted));
    if (isempty (k) || skeleton.points(k) == 0)
      error ("%s: option trace: no link \"%s\"; known: %s", who, wanted, ...
             strjoin ([skeleton.body(2:end)', named(! cellfun (@isempty, named))], ", "));
    endif
    column = last(k);
  elseif (! isempty (wanted))
    if (! (isnumeric (wanted) && isscalar (wanted) && any (wanted == 1:last(end))))
      error (["%s: option trace must be the name of a link or a column of m.ske, 1 to %d, " ...
              "found %s"], who, last(end), gs.text.shown_value (wanted));
    endif
    column = wanted;
    k = find (column <= last, 1);
  endif
  if (! isempty (column))
    inside = column - last(k) + skeleton.points(k);
    name = ["path of " skeleton.body{k}];
    if (skeleton.points(k) > 1)
      name = sprintf ("%s, %s", name, ...
                      {"mass centre", sprintf("joint %d", inside)}{1 ...
                          + (inside <= skeleton.joints(k))});
    endif
  endif
endfunction
