## AT = fx_sections (BEAM, XI): of the sections at XI of a beam the values of its shapes, their
## slopes (modes x sections), and AT.product, matrices that, reshaped and times the coordinates of
## the modes, give the integrals of products of slopes in one plane up to each section: by Gauss
## points between the root and the section.

function at = fx_sections (beam, xi)
  n = numel (beam.modes);
  [x, w] = fx_gauss (20);
  at.xi = xi;
  at.product = zeros (n * numel (xi), n);
  for k = 1:n
    [at.phi(k, :), at.slope(k, :)] = beam.modes(k).shape (xi);
  end
  for j = 1:numel (xi)
    slope = zeros (n, numel (x));
    for k = 1:n
      [~, slope(k, :)] = beam.modes(k).shape (xi(j) * x);
    end
    G = xi(j) * (slope .* w) * slope';
    kinds = {beam.modes.kind};
    for a = 1:n
      for b = 1:n
        if (! strcmp (kinds{a}, kinds{b}) || ! any (strcmp (kinds{a}, {"y", "z"})))
          G(a, b) = 0;
        end
      end
    end
    at.product((j - 1) * n + (1:n), :) = G;
  end
end
