## text = gsmbp__outside (m, t, x, v)
## What a message adds where devices are outside their margins at T, X, V: "" if none is.

function text = gsmbp__outside (m, t, x, v)
  text = "";
  for one = gsmbp__margins (m, t, x', v')
    text = [text gsmbp__refusal("outside", one.said)];
  endfor
endfunction
