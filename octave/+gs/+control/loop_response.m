## L = gs.control.loop_response (c, i)
## The loop of the controller C broken at the input I of its plant, the others closed, a function of
## the frequencies [rad/s], by the sign at which -1 is the critical point.

function L = loop_response (c, i)
  [F, H, S] = deal (c.plant.a, c.plant.b, c.plant.c);
  nu = columns (H);
  Dy = c.D(:,1:rows (S));
  By = c.B(:,1:rows (S));
  other = eye (nu);
  other(i,i) = 0;
  A = [F + H * other * Dy * S, H * other * c.C; By * S, c.A];
  b = [H(:,i); zeros(rows (c.A), 1)];
  k = [Dy(i,:) * S, c.C(i,:)];
  y = gs.control.frequency_response (A, b, k);
  if (c.period > 0)
    L = @(w) -y (exp (1i * w * c.period));
  elseif (c.delay > 0)
    L = @(w) -y (1i * w) .* exp (-1i * w * c.delay);
  else
    L = @(w) -y (1i * w);
  endif
endfunction
