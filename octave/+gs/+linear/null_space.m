## N = gs.linear.null_space (H)
## An orthonormal basis of what H takes to zero; of a matrix without rows that is all.

function N = null_space (H)
  N = eye (columns (H));
  if (rows (H) > 0)
    N = null (H, 1e-9);
  endif
endfunction
