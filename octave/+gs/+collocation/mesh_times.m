## t = gs.collocation.mesh_times (c, T)
## The times of the points of a program C whose phases last T [s], a row.

function t = mesh_times (c, T)
  before = [0, cumsum(T(:)')(1:end-1)];
  t = c.t0 + before(c.phase) + T(c.phase)(:)' .* c.tau;
endfunction
