## x = gsmbp__vector (who, name, x, n, what)
## X as a column of N finite real numbers; an error of WHO about the argument NAME
## otherwise.  WHAT (may be left out) says what the numbers are.

function x = gsmbp__vector (who, name, x, n, what)
  if (nargin < 5)
    what = "";
  endif
  if (! (isnumeric (x) || islogical (x)) || ! isreal (x))
    found = class (x);
    if (isnumeric (x))
      found = "complex ones";
    endif
    error ("%s: argument %s: expected %d real numbers%s, found %s", who, name, n, what, found);
  elseif (numel (x) != n || (n > 0 && ! isvector (x)))
    error ("%s: argument %s: expected %d number%s%s, found %s", who, name, n,
           {"s", ""}{1 + (n == 1)}, what, sprintf ("%dx", size (x))(1:end-1));
  endif
  x = double (x(:));
  k = find (! isfinite (x), 1);
  if (! isempty (k))
    error ("%s: argument %s(%d) is not finite: %g", who, name, k, x(k));
  endif
endfunction
