## text = gs.text.html_table (heads, cells)
## A table of texts: HEADS, a cell array; CELLS, one with a row for each row.

function text = html_table (heads, cells)
  row = @(tag, list) ["<tr>", sprintf(["<" tag ">%s</" tag ">"], ...
                                      cellfun (@gs.text.html_escaped, list, "UniformOutput", ...
                                               false){:}), sprintf("</tr>\n")];
  text = row ("th", heads);
  for k = 1:rows (cells)
    text = [text, row("td", cells(k,:))];
  endfor
  text = [sprintf("<div class=\"table\"><table>\n"), text, sprintf("</table></div>\n")];
endfunction
