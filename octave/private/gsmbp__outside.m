## text = gsmbp__outside (m, t, x, v)
## What a message adds where devices are outside their margins at T, X, V: "" if none is.

function text = gsmbp__outside (m, t, x, v)
  text = "";
  for one = gsmbp__margins (m, t, x', v')
    text = [text "; outside a margin: " one.said];
  endfor
endfunction
