## The variants that gsmbp_choose takes are as accurate as was asked, and cheaper; the error beside
## the estimate.

function test_choose ()
  warning ("off", "gsmbp:stiff", "local");
  [full, less, truth] = choose_runs (gsmbp_fixture ("choose_full"), gsmbp_fixture ("choose_less"));
  gsmbp_check ("choose: three states less", ...
               columns (full (1e-4, "dp853").x) - columns (less (1e-4, "dp853").x) == 3);
  error_of = @(r) max (max (abs (r.x(:,1:3) - truth)));
  gsmbp_check ("choose: error of the variants for 1e-6 rad [rad]", ...
               error_of (less (1e-9, "dp853")), 1e-6);
  ## right-hand sides for a result within the stated accuracy
  for accuracy = [1e-4, 1e-6]
    [a, b] = deal (cheapest (full, error_of, accuracy), cheapest (less, error_of, accuracy));
    gsmbp_check (sprintf (["choose: within %.0e rad: %d calls of the full model, %d of the " ...
                           "chosen " ...
                           "one, more than 5 times"], accuracy, a, b), a > 5 * b);
  end
end

## fewest calls of the right-hand side over tolerances
function n = cheapest (run, error_of, accuracy)
  n = Inf;
  for rtol = 10 .^ -(2:8)
    r = run (rtol, "dp853");
    if (error_of (r) <= accuracy)
      n = min (n, r.stats.calls);
    end
  end
end
