## r = gs.model.named_results (m, r)
## The result R with the places of the points of the scene (`points`, three columns each) and the
## columns of its fields by name in the struct `of`.

function r = named_results (m, r)
  r.points = places (m, r);
  r.of = struct ();
  for row = gs.model.name_table (m)
    if (isfield (r, row.field) && columns (r.(row.field)) >= row.column)
      r.of.(row.name) = r.(row.field)(:,row.column);
    endif
  endfor
endfunction

function p = places (m, r)
  p = zeros (numel (r.t), 0);
  if (isfield (m, "points") && ! isempty (m.points) && any (strcmp (m.subroutines, "pnt")))
    p = m.module ("places", m.cst, numel (r.t), r.t(:), r.x(:,1:m.sizes.nq), ...
                  numel (m.points))';
  endif
endfunction
