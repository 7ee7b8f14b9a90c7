## lines = gs.controller.head_lines (c, name, mark)
## lines = gs.controller.head_lines (c, name, mark, said)
## What the comment ahead of the controller C says, lines behind a MARK; SAID: what it says of its
## memory and its law, where this is no linear one.

function lines = head_lines (c, name, mark, said)
  if (nargin < 4)
    said = {sprintf("Z (%d), inout: memory; all zero at the trim", rows (c.A)), ...
            "e = [Y - trim; R - trim], raw = trim + C Z + D e, U = raw within its limits,", ...
            "Z = A Z + B e + G (U - raw)."};
  endif
  said = {sprintf("One sample of the controller %s (%s).", name, c.method), ...
          sprintf("Period %.9g s, from the sample to the outputs %.9g s.", c.period, c.delay), ...
          listed("Y", c.measured, "measured"), listed("R", c.references, "references"), ...
          said{1}, listed("U", c.driven, "outputs, held until the next sample"), said{2:end}};
  said = said(! cellfun (@isempty, said));
  lines = {};
  for one = said
    for part = ostrsplit (wrapped (one{1}), "\n")
      lines{end+1} = [mark "     " part{1}];
    endfor
  endfor
  if (strcmp (mark, " *"))
    lines = strrep (lines, " *     ", " * ");
  endif
endfunction

function text = listed (letter, names, what)
  text = "";
  if (! isempty (names))
    text = sprintf ("%s (%d): %s: %s", letter, numel (names), what, strjoin (names(:)', ", "));
  endif
endfunction

## lines of 60 characters at most, where there are blanks
function text = wrapped (text)
  words = strsplit (text, " ");
  [text, n] = deal ("", 0);
  for word = words
    w = word{1};
    if (n > 0 && n + 1 + numel (w) > 60)
      text = [text "\n"];
      n = 0;
    elseif (n > 0)
      text = [text " "];
      n++;
    endif
    text = [text w];
    n += numel (w);
  endfor
endfunction
