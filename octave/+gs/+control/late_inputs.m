## [F, H] = gs.control.late_inputs (p)
## The sampled plant P of gs.control.sampled_plant with the inputs on their way as states behind its
## own: u of the sample before first.

function [F, H] = late_inputs (p)
  [n, nu] = size (p.H0);
  N = n + p.count * nu;
  F = zeros (N);
  H = zeros (N, nu);
  F(1:n,1:n) = p.F;
  place = @(k) n + (k - 1) * nu + (1:nu);   # of u[i-k]
  if (p.whole == 0)
    H(1:n,:) = p.H0;
  else
    F(1:n,place (p.whole)) = p.H0;
  endif
  if (p.count > p.whole)
    F(1:n,place (p.whole + 1)) = p.H1;
  endif
  if (p.count > 0)
    H(place (1),:) = eye (nu);
  endif
  for k = 2:p.count
    F(place (k),place (k - 1)) = eye (nu);
  endfor
endfunction
