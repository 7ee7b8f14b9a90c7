## text = gsmbp__wrong_mode (m, t, x, modes, k)
## Why the mode of event K of the model M, of those that are given, contradicts the state X at T
## (GSRSM in share/fortran/events).

function text = gsmbp__wrong_mode (m, t, x, modes, k)
  wanted = 0;
  why = "which has no mode";
  if (! strcmp (m.events(k).kind, "event"))
    [~, places, speeds, ends] = m.hld (t, x, zeros (m.sizes.nv, 1));
    [place, speed, ends] = deal (places(k), speeds(k), ends(1:2,k));
    moves = sprintf ("which moves at %.6g (m/s or rad/s)", speed);
    why = moves;
    if (! strcmp (m.events(k).kind, "stop"))
      wanted = sign (speed);
    elseif (abs (place - ends(1 + (modes(k) > 0))) ...
              > gsmbp__run_limit ("past_stop") * travel (place, ends))
      why = sprintf ("which is at %.6g between %.6g and %.6g (m or rad)", place, ends);
    endif
  endif
  text = ["option modes: ", ...
          gsmbp__refusal("wrong_mode", wanted, m.events(k).name, why, modes(k))];
endfunction

## GSTVL in share/fortran/events
function d = travel (place, ends)
  [~, near] = min (abs (ends - place));
  d = min (diff (ends), max (1, abs (ends(near))));
endfunction
