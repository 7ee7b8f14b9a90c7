## text = gsmbp__quoted (text)
## A string of gnuplot.

function text = gsmbp__quoted (text)
  text = ["'" strrep(text, "'", "''") "'"];
endfunction
