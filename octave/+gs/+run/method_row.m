## row = gs.run.method_row (method)
## The row of a METHOD of integration (share/engine/core/gsmbp/methods.h): a struct with NUMBER (in
## iopt), FIXED (are its steps of one length?), BY (core, engine, library, both), ORDERS (that
## maxorder takes) and ORDER (the default).

function row = method_row (method)
  persistent known = struct ();   # each run asks twice
  if (! isfield (known, method))
    known.(method) = row_of (method);
  endif
  row = known.(method);
endfunction

function row = row_of (method)
  rows = gs.text.table_rows ("GS_METHODS");
  found = rows(strcmp (rows(:,1), method),:);
  row = struct ("number", str2double (found{2}), "fixed", strcmp (found{3}, "fixed"), ...
                "by", found{4}, "orders", sscanf (found{5}, "%d")', ...
                "order", str2double (found{6}));
endfunction
