## x = gs.given.given_vector (who, name, x, n, what, names)
## X as a column of N finite real numbers, none above 1e300 in size (which the emitted Fortran
## does not take); an error of WHO about the argument NAME otherwise (or the option, where NAME
## says so: "option start").  WHAT (may be left out)
## says what the numbers are, NAMES (a cell array, may be left out) what each is called: X may then
## be a struct or a cell array of names and values, too.

function x = given_vector (who, name, x, n, what = "", names = {})
  if (! strncmp (name, "option ", 7))
    name = ["argument " name];
  endif
  by_name = isstruct (x) || (iscell (x) && ! isempty (x) && iscellstr (x(1:2:end)));
  if (by_name && numel (names) == n)
    x = gs.given.values_by_names (who, name, x, names);
  endif
  if (! (isnumeric (x) || islogical (x)) || ! isreal (x))
    found = class (x);
    if (isnumeric (x))
      found = "complex ones";
    endif
    error ("%s: %s: expected %d real numbers%s, found %s", who, name, n, what, found);
  elseif (numel (x) != n || (n > 0 && ! isvector (x)))
    error ("%s: %s: expected %d number%s%s, found %s", who, name, n,
           {"s", ""}{1 + (n == 1)}, what, sprintf ("%dx", size (x))(1:end-1));
  endif
  x = double (x(:));
  k = find (! (abs (x) <= 1e300), 1);
  if (! isempty (k))
    called = "";
    if (numel (names) == n)
      called = [", " names{k}];
    endif
    called = sprintf ("%s(%d)%s", name, k, called);
    if (isfinite (x(k)))
      error ("%s: %s is too large (at most 1e300): %g", who, called, x(k));
    endif
    error ("%s: %s", who, gs.text.refusal_text ("not_finite", called, x(k)));
  endif
endfunction
