## table = gs.run.option_table ()
## Return the options of gsmbp_simulate (share/engine/core/gsmbp/options.h): name, default, kind.
## The default NaN of rtol is that of the table; no user can give it, so that a tolerance that is
## not used can be reported.

function table = option_table ()
  persistent made = read_table ();
  table = made;
endfunction

function table = read_table ()
  rows = gs.text.table_rows ("GS_OPTIONS");
  table = [rows(:,1), cellfun(@default, rows(:,3), rows(:,2), "UniformOutput", false), ...
           cellfun(@kind, rows(:,2), "UniformOutput", false)];
  table{strcmp (rows(:,1), "rtol"),2} = NaN;
  table{strcmp (rows(:,1), "loops"),2} = "";
endfunction

function value = default (text, kind)
  value = str2double (text);
  if (any (strcmp (text, {"true", "false"})))
    value = strcmp (text, "true");
  elseif (strcmp (text, "none"))
    value = {[], {}}{1 + strcmp(kind, "names")};
  elseif (isnan (value))
    value = text;
  endif
endfunction

## words for an option of words
function value = kind (value)
  if (any (strcmp (value, {"method", "start"})))
    words = gs.text.table_rows (["GS_" toupper(value) "S"]);
    value = words(:,1)';
  endif
endfunction
