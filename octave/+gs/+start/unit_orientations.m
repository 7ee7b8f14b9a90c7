## x = gs.start.unit_orientations (m, x)
## X with Euler parameters of length 1.

function x = unit_orientations (m, x)
  for set = m.orientation'
    n = norm (x(set));
    if (n > 0)
      x(set) /= n;
    endif
  endfor
  if (isempty (m.orientation) && m.sizes.nq > m.sizes.nu && m.sizes.nlam == 0)
    x = m.prj (0, x);
  endif
endfunction
