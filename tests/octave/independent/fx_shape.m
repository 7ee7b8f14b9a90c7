## [PHI, SLOPE] = fx_shape (ENDS, I, XI): eigenfunction I of a beam (clamped_free, clamped_clamped,
## pinned_pinned) or rod (fixed_free, fixed_fixed), integral of its square 1, and its derivative, at
## XI from 0 to 1; by exponentials that do not cancel.

function [phi, slope] = fx_shape (ends, i, xi)
  switch (ends)
    case {"pinned_pinned", "fixed_fixed"}
      b = i * pi;
    case "fixed_free"
      b = (i - 1/2) * pi;
    otherwise
      s = merge (strcmp (ends, "clamped_free"), 1, -1);
      b = fzero (@(b) cos (b) + s / cosh (b), (i - s / 2) * pi + [-0.5, 0.5], optimset ("TolX", 0));
      sigma = (cosh (b) + s * cos (b)) / (sinh (b) + s * sin (b));
      ## cosh - sigma sinh = exp(-z) sigma_+ + exp(z) (1 - sigma)/2
      less = (s * (sin (b) - cos (b)) - exp (-b)) / (sinh (b) + s * sin (b));   # 1 - sigma
      z = b * xi;
      up = less / 2 * exp (z);
      down = (1 + sigma) / 2 * exp (-z);
      phi = up + down - cos (z) + sigma * sin (z);
      slope = b * (up - down + sin (z) + sigma * cos (z));
      return;
  end
  phi = sqrt (2) * sin (b * xi);
  slope = sqrt (2) * b * cos (b * xi);
end
