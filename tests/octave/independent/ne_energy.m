## [kinetic, potential, dissipated, given] = ne_energy (M, Q, U): summed over the bodies, and
## springs; potential of gravity zero where the mass centres are at the world's origin; the power
## that dampers take, and that given forces bring.

function [kinetic, potential, dissipated, given] = ne_energy (m, q, u)
  k = ne_rows (m, q, u);
  velocity = [k.v; k.w](:);
  kinetic = velocity' * k.mass * velocity / 2;
  potential = -[m.body.mass] * (k.com' * m.gravity);
  [nq, nu] = ne_sizes (m);
  dissipated = i = j = 0;
  for l = 1:numel (m.joint)
    joint = m.joint(l);
    own = nu(l) - 3 * (nq(l) > nu(l));
    potential += sum (joint.stiffness(1:own) .* (q(i + (1:own))(:) - joint.rest(1:own)) .^ 2) / 2;
    dissipated += sum (joint.damping(1:own) .* u(j + (1:own))(:) .^ 2);
    i += nq(l);
    j += nu(l);
  end
  if (isfield (m, "spring"))
    for s = m.spring
      [d, rate] = ne_distance (k, s);
      potential += s.stiffness * (d - s.rest) ^ 2 / 2;
      dissipated += s.damping * rate ^ 2;
    end
  end
  given = 0;
  if (nargout > 3 && isfield (m, "given") && ! isempty (m.given))
    without = setfield (m, "given", []);
    given = velocity' * (k.force - ne_rows (without, q, u).force);
  end
end
