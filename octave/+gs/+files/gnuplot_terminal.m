## text = gs.files.gnuplot_terminal (kind, size, o)
## The terminal of gnuplot for a file that ends in KIND (.png, .pdf, .svg, .eps), SIZE in cm; O:
## dpi, fontsize.

function text = gnuplot_terminal (kind, size, o)
  switch (kind)
    case ".png"
      text = sprintf ("pngcairo size %d,%d fontscale %.4f linewidth %.4f", ...
                      round (size * o.dpi / 2.54), o.dpi / 96, o.dpi / 110);
    case ".pdf"
      text = sprintf ("pdfcairo size %.4fcm,%.4fcm fontscale 0.75 linewidth 1", size);
    case ".eps"
      text = sprintf ("epscairo size %.4fcm,%.4fcm fontscale 0.75 linewidth 1", size);
    case ".svg"
      text = sprintf ("svg size %d,%d fontscale 1.3333 linewidth 0.9", round (size * 96 / 2.54));
  endswitch
  text = sprintf ("%s enhanced font 'FreeSans,%g'", text, o.fontsize);
endfunction
