## [truth, known, m] = bench_truth (name, out, x0, times, options)
##
## The rows of states at TIMES of the same Fortran in quad precision at a tolerance of 1e-18, by the
## first way that succeeds; KNOWN is how far a run at 1e-15 is from it (largest deviation of a
## coordinate). Without success TRUTH is [].

function [truth, known, way] = bench_truth (name, out, x0, times, options)
  q = gsmbp_build (name, "directory", out, "precision", "quad");
  truth = [];
  known = Inf;
  for one = {"projection", "partitioning", "kane"}
    way = one{1};
    run = @(tol) gsmbp_simulate (q, x0, times, options{:}, "loops", way, "rtol", tol, "drift", ...
                                 false, "maxsteps", 30000);
    [s, info] = run (1e-18);
    if (info == 0)
      truth = s.x;
      [s, info] = run (1e-15);
      if (info == 0)
        known = max (max (abs (s.x - truth)(:,1:q.sizes.nq)));
      end
      return;
    end
  end
end
