## text = gs.text.pole_text (poles, h)
## POLES as an error names them; of z where H > 0.

function text = pole_text (poles, h)
  one = @(s) sprintf ("%.5g", s);
  words = cell (1, 0);
  for s = poles(:).'
    if (imag (s) == 0)
      words{end+1} = sprintf ("%.5g", real (s));
    elseif (imag (s) > 0)
      words{end+1} = sprintf ("%.5g +- %.5gi", real (s), imag (s));
    endif
  endfor
  text = [strjoin(words, ", ") {"", " (of z)"}{1 + (h > 0)}];
endfunction
