## text = gs.text.gnuplot_quoted (text)
## A string of gnuplot.

function text = gnuplot_quoted (text)
  text = ["'" strrep(text, "'", "''") "'"];
endfunction
