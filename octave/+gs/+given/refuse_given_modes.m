## gs.given.refuse_given_modes (who, m, inputs, modes)
## Refuses rows of all INPUTS of the scene M that have in the place of a mode a number that is not
## 0 nor that of option MODES, [] if it is not given: it would not count.

function refuse_given_modes (who, m, inputs, modes)
  if (isempty (inputs) || isempty (m.events))
    return;
  endif
  if (isempty (modes))
    modes = zeros (1, numel (m.events));
  endif
  for k = find ([m.events.input] > 0)
    given = inputs(:, m.events(k).input);
    wrong = find (given != 0 & given != modes(k), 1);
    if (! isempty (wrong))
      error ("%s: %s", who, ...
             gs.text.refusal_text ("given_mode", m.events(k).name, given(wrong)));
    endif
  endfor
endfunction
