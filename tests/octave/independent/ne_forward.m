## [ud, lam] = ne_forward (M, Q, U, TAU): joint accelerations and loop forces (on body B) under the joint efforts TAU, damping of the case included.
## One linear system of all body accelerations and all constraint forces; no mass matrix of joint coordinates is formed.

function [ud, lam] = ne_forward (m, q, u, tau)
  n = numel (m.body);
  k = ne_rows (m, q, u);
  effort = tau(:) - [m.joint.damping]' .* u(:);
  held = setdiff (1:6 * n, k.free);
  H = [k.J(held, :); k.L];
  both = [k.mass, -H'; H, zeros(rows (H))] \ [k.force + k.J(k.free, :)' * effort; k.gamma(held); k.gamma_loop];
  ud = k.J(k.free, :) * both(1:6 * n) - k.gamma(k.free);
  lam = both(6 * n + numel (held) + 1:end);
end
