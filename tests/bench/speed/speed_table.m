## text = speed_table (title, words, head, rows): a section of the report: title, sentences, table
## (a cell of cells of text); "" without rows.

function text = speed_table (title, words, head, rows)
  text = "";
  if (! isempty (rows))
    line = @(cells) ["| " strjoin(cells, " | ") " |\n"];
    text = [sprintf("\n## %s\n\n%s\n\n", title, words), line(head), ...
            "|" repmat("---|", 1, numel (head)) "\n", ...
            cellfun(line, rows, "UniformOutput", false){:}];
  end
end
