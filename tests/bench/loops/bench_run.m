## r = bench_run (m, x0, times, options, seconds, truth)
##
## One simulation with the OPTIONS of gsmbp_simulate, repeated for SECONDS and at least seven times
## (not at all if SECONDS is 0 or a run takes long); a struct: info, failure (text, empty if all
## went well), seconds for each simulated second (the shortest run), calls, phi, phidot (largest
## after any step), energy (largest change of kinetic + potential + stored energy beside what a case
## without supply and losses exchanges; NaN with supply or losses), error (largest deviation of a
## coordinate from the rows TRUTH; NaN if TRUTH is []), steps, rejected, rank_losses (calls),
## singular (positions that were reported), exchanged [J], last (state at the end).

function r = bench_run (m, x0, times, options, seconds, truth)
  try
    [s, info] = gsmbp_simulate (m, x0, times, options{:});
  catch problem
    r = struct ("info", -1, "failure", regexprep (problem.message, "^gsmbp_simulate: *|\n", ...
        ""), "seconds", NaN, "calls", NaN, "steps", NaN, "rejected", NaN,
                "rank_losses", NaN, "singular", NaN, "phi", NaN, "phidot", NaN, "energy", NaN, ...
                    "exchanged", NaN, "error", NaN, "last", []);
    return;
  end
  best = s.stats.seconds;
  spent = best;
  runs = 1;
  while (info == 0 && seconds > 0 && (spent < seconds || runs < 7 && best < 0.2))
    runs++;
    again = gsmbp_simulate (m, x0, times, options{:});
    best = min (best, again.stats.seconds);
    spent += max (again.stats.seconds, 1e-4);
  end
  r.info = info;
  r.failure = "";
  if (info != 0)
    words = {"too many steps", "step too small", "a routine failed", "not finite"};
    r.failure = sprintf ("%s at %.4g s", words{min (info, 4)}, s.stats.reached);
  end
  r.seconds = best / (times(end) - times(1));
  r.calls = s.stats.calls;
  r.steps = s.stats.accepted;
  r.rejected = s.stats.rejected;
  r.rank_losses = s.stats.rank_losses;
  r.singular = s.stats.singular_positions;
  r.phi = s.stats.drift.phi;
  r.phidot = s.stats.drift.phidot;
  r.energy = r.exchanged = r.error = NaN;
  r.last = s.x(end,:);
  if (info == 0)
    [r.energy, r.exchanged] = energy (m, s);
    if (! isempty (truth))
      r.error = max (max (abs (s.x(:,1:m.sizes.nq) - truth(:,1:m.sizes.nq))));
    end
  end
end

function [drift, exchanged] = energy (m, s)
  drift = exchanged = NaN;
  if (! any (strcmp (m.subroutines, "ene")))
    return;
  end
  e = cell2mat (arrayfun (@(i) m.ene (s.t(i), s.x(i,:)', s.v(i,:)'), 1:numel (s.t), ...
                          "UniformOutput", false));
  exchanged = max (range (e(1,:)), range (sum (e(2:3,:), 1)));
  if (! any (any (e(4:5,:))))
    total = sum (e(1:3,:), 1);
    drift = max (abs (total - total(1))) / max (exchanged, realmin);
  end
end
