## mesh = gs.collocation.finer_mesh (mesh, errors, accuracy)
## The intervals of a mesh whose ERRORS are too large cut, the more the larger, in five at most.

function mesh = finer_mesh (mesh, errors, accuracy)
  parts = ceil ((2 * errors / accuracy) .^ (1 / (mesh.rule.order + 1)));
  parts = max (1, min (parts, 5));
  breaks = [];
  for k = 1:numel (parts)
    b = linspace (mesh.breaks(2,k), mesh.breaks(3,k), parts(k) + 1);
    breaks = [breaks, [mesh.breaks(1,k) * ones(1, parts(k)); b(1:end-1); b(2:end)]];
  endfor
  mesh.breaks = breaks;
endfunction
