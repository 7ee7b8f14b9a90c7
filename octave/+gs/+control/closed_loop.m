## [A, B, C] = gs.control.closed_loop (c)
## Plant and controller C as one: states of the plant, then of the controller; inputs: references,
## disturbances at the inputs of the plant; outputs: measurements, then the controller's.

function [A, B, C] = closed_loop (c)
  [F, H, S] = deal (c.plant.a, c.plant.b, c.plant.c);
  ny = rows (S);
  [By, Br] = deal (c.B(:,1:ny), c.B(:,ny+1:end));
  [Dy, Dr] = deal (c.D(:,1:ny), c.D(:,ny+1:end));
  A = [F + H * Dy * S, H * c.C; By * S, c.A];
  B = [H * Dr, H; Br, zeros(rows (c.A), columns (H))];
  C = [S, zeros(ny, rows (c.A)); Dy * S, c.C];
endfunction
