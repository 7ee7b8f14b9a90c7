## y = gsmbp__response (A, b, k, s)
## k (s I - A)^-1 b at all of the points S of the complex plane, by one Schur form.

function y = gsmbp__response (A, b, k, s)
  [A, b, k] = gsmbp__balanced (A, b, k);
  [U, T] = schur (complex (A));
  b = U' * b;
  k = k * U;
  n = rows (A);
  x = zeros (n, numel (s));
  for i = n:-1:1
    x(i,:) = (b(i) + T(i,i+1:n) * x(i+1:n,:)) ./ (s(:).' - T(i,i));
  endfor
  y = reshape (k * x, size (s));
endfunction
