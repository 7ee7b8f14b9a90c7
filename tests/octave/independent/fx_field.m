## R = fx_field (BEAM, Q): places (3 x n, axes of the beam) and angles about x, y, z of the sections
## of a beam of fx_beam AT some sections (fx_sections).

function r = fx_field (beam, q, at)
  r.place = [beam.L * at.xi; zeros(2, numel (at.xi))];
  r.angles = zeros (3, numel (at.xi));
  for k = 1:numel (beam.modes)
    switch (beam.modes(k).kind)
      case "y"
        r.place(2, :) += at.phi(k, :) * q(k);
        r.angles(3, :) += at.slope(k, :) * q(k) / beam.L;
      case "z"
        r.place(3, :) += at.phi(k, :) * q(k);
        r.angles(2, :) -= at.slope(k, :) * q(k) / beam.L;
      case "twist"
        r.angles(1, :) += at.phi(k, :) * q(k);
      case "stretch"
        r.place(1, :) += at.phi(k, :) * q(k);
    end
  end
  if (! strcmp (beam.model, "linear"))
    r.place(1, :) -= q.' * reshape (at.product * q, numel (q), []) / (2 * beam.L);
  end
end
