## ten = gs.identify.ten_parameters (P)
## The ten standard parameters m, hx, hy, hz, Ixx, Iyy, Izz, Ixy, Ixz, Iyz of a pseudo-inertia.

function ten = ten_parameters (P)
  I = trace (P(1:3,1:3)) * eye (3) - P(1:3,1:3);
  ten = [P(4,4); P(1:3,4); I(1,1); I(2,2); I(3,3); I(1,2); I(1,3); I(2,3)];
endfunction
