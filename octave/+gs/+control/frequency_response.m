## y = gs.control.frequency_response (A, b, k)
## k (s I - A)^-1 b by one Schur form, a function of the points s of the complex plane.

function y = frequency_response (A, b, k)
  [A, b, k] = gs.control.balanced_system (A, b, k);
  [U, T] = schur (complex (A));
  [b, k] = deal (U' * b, k * U);
  y = @(s) at (T, b, k, s);
endfunction

function y = at (T, b, k, s)
  n = rows (T);
  x = zeros (n, numel (s));
  for i = n:-1:1
    x(i,:) = (b(i) + T(i,i+1:n) * x(i+1:n,:)) ./ (s(:).' - T(i,i));
  endfor
  y = reshape (k * x, size (s));
endfunction
