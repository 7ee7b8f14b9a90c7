## [F, omega] = gs.drive.screw_limits (screw, support)
## The force [N] and the speed [rad/s] that a SCREW of the catalogue (steel) is allowed with its
## SUPPORT (gs.drive.screw_support): half of Euler's load, 0.8 of the first critical speed; infinite
## without support or root diameter.

function [F, omega] = screw_limits (screw, support)
  [F, omega] = deal (Inf);
  if (isempty (support) || ! isfinite (screw.d_root))
    return;
  endif
  [E, rho] = deal (2.1e11, 7850);
  [I, A] = deal (pi * screw.d_root ^ 4 / 64, pi * screw.d_root ^ 2 / 4);
  F = 0.5 * support.euler * E * I / support.length ^ 2;
  omega = 0.8 * support.whirl * sqrt (E * I / (rho * A)) / support.length ^ 2;
endfunction
