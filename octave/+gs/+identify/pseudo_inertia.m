## P = gs.identify.pseudo_inertia (ten)
## The pseudo-inertia of ten standard parameters m, hx, hy, hz, Ixx, Iyy, Izz, Ixy, Ixz, Iyz.

function P = pseudo_inertia (ten)
  I = [ten(5), ten(8), ten(9); ten(8), ten(6), ten(10); ten(9), ten(10), ten(7)];
  half = (ten(5) + ten(6) + ten(7)) / 2;
  P = [half * eye(3) - I, ten(2:4)(:); ten(2:4)(:)', ten(1)];
endfunction
