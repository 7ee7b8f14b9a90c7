## u = gs.sweep.sobol_points (who, n, k)
## N points of Sobol's sequence in K dimensions, from the second on (the first is a corner), in the
## middle of their cells of 2^-32: direction numbers of Joe and Kuo (new-joe-kuo-6), 21 dimensions
## at most.

function u = sobol_points (who, n, k)
  ## degree s, coefficients a, first direction numbers
  known = {0, 0, []; 1, 0, 1; 2, 1, [1 3]; 3, 1, [1 3 1]; 3, 2, [1 1 1]; 4, 1, [1 1 3 3];
           4, 4, [1 3 5 13]; 5, 2, [1 1 5 5 17]; 5, 4, [1 1 5 5 5]; 5, 7, [1 1 7 11 19];
           5, 11, [1 1 5 1 1]; 5, 13, [1 1 1 3 11]; 5, 14, [1 3 5 5 31]; 6, 1, [1 3 3 9 7 49];
           6, 13, [1 1 1 15 21 21]; 6, 16, [1 3 1 13 27 49]; 6, 19, [1 1 1 15 7 5];
           6, 22, [1 3 1 15 13 25]; 6, 25, [1 1 5 5 19 61]; 7, 1, [1 3 7 11 23 15 103];
           7, 4, [1 3 7 13 13 15 69]};
  if (k > rows (known))
    error (["%s: expected at most %d dimensions of a plan of Sobol points (\"indices\" needs " ...
            "two a parameter), found %d"], who, rows (known), k);
  endif
  u = zeros (n, k);
  for j = 1:k
    v = directions (known{j,:});
    x = zeros (1, 1, "uint64");
    for b = 1:ceil (log2 (n + 1))   # Gray's code: what is there in turned order, with bit b
      x = [x; bitxor(flipud (x), v(b))];
    endfor
    u(:,j) = (double (x(2:n+1)) + 0.5) / 2 ^ 32;
  endfor
endfunction

## the 32 direction numbers of one dimension
function v = directions (s, a, first)
  m = ones (1, 32);
  m(1:s) = first;
  for b = s+1:32
    if (s == 0)
      break;
    endif
    next = bitxor (m(b-s), m(b-s) * 2 ^ s);
    for q = 1:s-1
      if (bitand (a, 2 ^ (s - 1 - q)))
        next = bitxor (next, m(b-q) * 2 ^ q);
      endif
    endfor
    m(b) = next;
  endfor
  v = uint64 (m .* 2 .^ (32 - (1:32)));
endfunction
