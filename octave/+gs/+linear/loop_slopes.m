## [X, dtau, dlam] = gs.linear.loop_slopes (who, m, t, motion, tau, lam, planned, Q, P)
## How a motion of a closed chain and its efforts change (ILP): MOTION, a column each of
## coordinates, speeds and accelerations, with the efforts TAU and multipliers LAM of INL.  Q: the
## changes of the coordinates PLANNED, of their speeds and accelerations, numel (planned) x 3 x n;
## P: of the parameters m.json.sensitivity, a column for each of the n changes.  X: nu x 3 x n; an
## error where the loops are singular.

function [X, dtau, dlam] = loop_slopes (who, m, t, motion, tau, lam, planned, Q, P)
  d = m.sizes;
  n = columns (P);
  [nu, nm] = deal (d.nu, 3 * d.nu);
  v = zeros (d.nv, 1);
  D = m.ilp (t, motion(:,1), motion(:,2), motion(:,3), v, tau(:), lam(:));
  known = [planned(:); nu + planned(:); 2*nu + planned(:)]';
  others = setdiff (1:4*nu, known);
  change = D(:,known) * reshape (Q, 3 * numel (planned), n) + D(:,4*nu+1:end) * P;
  E = D(:,others);
  size_ = max (abs (E), [], 2);
  size_(size_ == 0) = 1;
  E ./= size_;
  wide = max (abs (E), [], 1);
  if (rows (E) != columns (E) || any (wide == 0) || rcond (E ./ wide) < 1e-13)
    error ("%s: %s: no derivatives by the loops at t = %.9g s: the position is singular for %s", ...
           who, m.name, t, strjoin (m.coordinates(planned)(:)', ", "));
  endif
  z = -((E ./ wide) \ (change ./ size_)) ./ wide';
  X = zeros (nm, n);
  X(known,:) = reshape (Q, 3 * numel (planned), n);
  inner = others <= nm;
  X(others(inner),:) = z(inner,:);
  X = reshape (X, nu, 3, n);
  e = z(! inner,:);
  dtau = e(1:d.nact,:);
  dlam = e(d.nact+1:end,:);
endfunction
