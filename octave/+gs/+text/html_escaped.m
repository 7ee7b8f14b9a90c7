## text = gs.text.html_escaped (text)
## A text as HTML and XML show it: what was written is seen, and no markup.

function text = html_escaped (text)
  text = text(text >= " " | text == "\n" | text == "\t");
  for pair = {"&", "&amp;"; "<", "&lt;"; ">", "&gt;"; "\"", "&quot;"; "'", "&#39;"}'
    text = strrep (text, pair{:});
  endfor
endfunction
