## text = gs.start.outside_range (m, t, x, v)
## What a message adds where devices are outside their margins at T, X, V: "" if none is.

function text = outside_range (m, t, x, v)
  text = "";
  for one = gs.start.range_margins (m, t, x', v')
    text = [text gs.text.refusal_text("outside", one.said)];
  endfor
endfunction
