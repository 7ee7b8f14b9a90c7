## rows = gsmbp__run_table (table)
## Return the rows of the TABLE GS_... of options, limits or refusals in share/c/gsmbp, which all
## hosts of runs share: a cell array of texts, a row each.

function rows = gsmbp__run_table (table)
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
  text = cellfun (@(file) fileread (gsmbp__place ("share", "c", "gsmbp", file)), ...
                  {"options.h", "limits.h", "refusals.h"}, "UniformOutput", false);
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
