## rows = gs.text.table_rows (table)
## The rows of the TABLE GS_... of options, limits, refusals or verdicts in
## share/engine/core/gsmbp, which all hosts of runs share: a cell array of texts, a row each.

function rows = table_rows (table)
  persistent known = struct ();
  if (! isfield (known, table))
    known.(table) = read_rows (table);
  endif
  rows = known.(table);
endfunction

function rows = read_rows (table)
  persistent text = texts ();
  pattern = ['#define ' table '\(ROW\)((?:[^\n]*\\\n)*[^\n]*)'];
  body = regexprep (regexp (text, pattern, "tokens", "once"){1}, '/\*.*?\*/|\\\n', "");
  found = [regexp(body, 'ROW \(((?:[^()"]|"(?:\\.|[^"\\])*")*)\)', "tokens"){:}];
  found = cellfun (@parts, found, "UniformOutput", false);
  rows = vertcat (found{:});
endfunction

function text = texts ()
  text = cellfun (@(file) fileread (gs.files.own_place ("share", "engine/core/gsmbp", file)), ...
                  {"options.h", "methods.h", "limits.h", "refusals.h", "failures.h"}, ...
                  "UniformOutput", false);
  text = [text{:}];
endfunction

## name, text, or name, word, ...
function list = parts (row)
  texts = [regexp(row, '"((?:\\.|[^"\\])*)"', "tokens"){:}];
  list = strtrim (strsplit (row, ","));
  if (! isempty (texts))
    list = {list{1}, do_string_escapes([texts{:}])};
  endif
endfunction
