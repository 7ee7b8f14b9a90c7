## r = gsmbp__named (m, r)
## The result R with the columns of its fields by name in the struct `of`.

function r = gsmbp__named (m, r)
  r.of = struct ();
  for row = gsmbp__table (m)
    if (isfield (r, row.field) && columns (r.(row.field)) >= row.column)
      r.of.(row.name) = r.(row.field)(:,row.column);
    endif
  endfor
endfunction
