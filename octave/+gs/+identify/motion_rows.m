## a = gs.identify.motion_rows (regression, d, B, f)
## The REGRESSION of the motion with the coefficients F.c of the splines B at
## the parameters F.p: a.Y, a.rest (measured less predicted), and a.D{i}, the derivatives of effort
## i by the coefficients of one coordinate after the other.

function a = motion_rows (regression, d, B, f)
  n = columns (f.c);
  d = gs.identify.spline_derivatives (d, B, f.c);
  a = regression (d);
  a.rest = a.b - a.Y * f.p;
  p = f.p;
  p(strcmp (a.kind, "coulomb")) = 0;   # its derivative is zero
  before = a.measured - a.b + a.Y * p;
  a.D = cell (1, n);
  for j = 1:n
    part = repmat ({0}, 1, n);
    for k = 1:3
      slope = by_one (regression, d, {"q", "u", "ud"}{k}, j, p, before);
      for i = 1:n
        part{i} += diag (slope(i:n:end)) * B{k};
      endfor
    endfor
    a.D = cellfun (@horzcat, a.D, part, "UniformOutput", false);
  endfor
endfunction

## the derivative of all efforts by a position, speed or acceleration (NAME) of the coordinate J
function slope = by_one (regression, d, name, j, p, before)
  h = 1e-7 * max (1e-3, max (abs (d.(name)(:,j))));
  d.(name)(:,j) += h;
  w = regression (d);
  slope = (w.measured - w.b + w.Y * p - before) / h;
endfunction
