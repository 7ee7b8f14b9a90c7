## [kinetic, potential] = ne_energy (M, Q, U): summed over the bodies; potential zero where the mass centres are at the world's origin.

function [kinetic, potential] = ne_energy (m, q, u)
  k = ne_rows (m, q, u);
  velocity = [k.v; k.w](:);
  kinetic = velocity' * k.mass * velocity / 2;
  potential = -[m.body.mass] * (k.com' * m.gravity);
end
