## parts = gs.controller.sum_terms (to, terms, number, place, times)
## The rows {factor, name} of a sum as {sign, text} in the words of a language: NUMBER and PLACE
## write a factor and a name, TIMES stands between them.  The first sign is "=", those behind it "+"
## or "-"; a sum that begins with its own target TO leaves that out.

function parts = sum_terms (to, terms, number, place, times)
  parts = cell (0, 2);
  if (isempty (terms))
    parts = {"=", number(0)};
  endif
  for k = 1:rows (terms)
    [f, name] = terms{k,:};
    if (isempty (name))
      text = number (f);
    elseif (f == 1)
      text = place (name);
    elseif (f == -1)
      text = ["-" place(name)];
    else
      text = [number(f) times place(name)];
    endif
    if (k == 1 && strcmp (text, to))
      continue;
    elseif (k == 1)
      parts(end+1,:) = {"=", text};
    elseif (text(1) == "-")
      parts(end+1,:) = {"-", text(2:end)};
    else
      parts(end+1,:) = {"+", text};
    endif
  endfor
endfunction
