## [e, growth] = global_errors (M, X0, T, OPTIONS, WAYS, TOLERANCES): the global error of runs
## beside the truth (dp853 at rtol 1e-13), over the tolerance, a row for each of WAYS (cells of
## options of gsmbp_simulate), a column for each of TOLERANCES (rtol; atol is rtol times
## m.nominal). An error of a state counts beside what its tolerance is a part of: the usual size
## m.nominal plus the largest modulus in the run. GROWTH: for each of TOLERANCES how much a
## perturbation of the start of that size grows at most to any of the times T, measured alike: a
## start for each state that is moved by itself, put back on the constraints (one that cannot run
## does not count).
## NaN: the run failed. The bound that holds is e <= 100 * max (1, growth).

function [e, growth] = global_errors (m, x0, t, options, ways, tolerances)
  tight = {options{:}, "rtol", 1e-13, "start", "project"};
  truth = gsmbp_simulate (m, x0, t, tight{:}).x;
  usual = m.nominal' + max (abs (truth), [], 1);
  gaps = @(x) max (abs (x - truth) ./ usual, [], 2);
  growth = zeros (1, numel (tolerances));
  e = NaN (numel (ways), numel (tolerances));
  for k = 1:numel (tolerances)
    for s = 1:numel (x0)
      y = x0(:);
      y(s) += tolerances(k) * usual(s);
      try
        far = gaps (gsmbp_simulate (m, y, t, tight{:}).x);
      catch
        continue;
      end
      if (far(1) > tolerances(k) / 100)   # else the constraints do not let this state move
        growth(k) = max (growth(k), max (far) / far(1));
      end
    end
    for w = 1:numel (ways)
      [r, info] = gsmbp_simulate (m, x0, t, options{:}, ways{w}{:}, "rtol", tolerances(k));
      if (info == 0)
        e(w,k) = max (gaps (r.x)) / tolerances(k);
      end
    end
  end
end
