## gsmbp_check (WHAT, ERROR, TOLERANCE): one test; passes when every |ERROR| <= TOLERANCE (a NaN or
## an empty one fails). Prints what was measured. gsmbp_check (WHAT, TRUTH): passes when every entry
## is true.

function passed = gsmbp_check (what, value, tolerance)
  word = {"not ok", "ok"};
  if (nargin < 3)
    passed = ! isempty (value) && all (logical (value(:)));
    said = "";
    if (! passed)
      said = sprintf (": expected true everywhere, found false in %d of %d entries", ...
                      sum (! value(:)), numel (value));
    end
    printf ("%s %s%s\n", word{1 + passed}, what, said);
  else
    worst = max (abs (value(:)));
    passed = ! isempty (value) && ! any (isnan (value(:))) && worst <= tolerance;
    if (any (isnan (value(:))))
      worst = NaN;
    end
    printf ("%s %s: %.1e (at most %.0e)\n", word{1 + passed}, what, worst, tolerance);
  end
  fflush (stdout);
end
