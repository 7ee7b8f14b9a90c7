## c = gs.draw.line_colors (n)
## N colours of curves, "#rrggbb", from the start again where there are more.

function c = line_colors (n)
  c = {"#00459a", "#cc3318", "#1a7f37", "#80339a", "#d98c00", "#3399b3", "#4d4d4d"};
  c = c(mod (0:n-1, numel (c)) + 1);
endfunction
