## a = gs.run.energy_audit (m, r, w)
## The energy audit of the run R of the model M: W has its two states, a row for each time.

function a = energy_audit (m, r, w)
  if (isempty (r.x))
    a = struct ("balance", [], "passed", [], "error", NaN);
    return;
  endif
  energy = gs.run.energy_sums (m, r.t, r.x, r.v);
  energy = energy(:,1:3);   # kinetic, potential, in devices
  stored = sum (energy, 2);
  lost = zeros (rows (r.x), 1);   # in impacts
  if (isfield (r, "events"))
    lost = sum (r.events.loss' .* (r.events.t' <= r.t), 2);
  endif
  a.balance = stored - stored(1) - w(:,1) + lost - lost(1);
  a.passed = w(:,2) + lost;
  ## what the energies themselves are rounded to is no error
  rounding = 64 * eps * max (sum (abs (energy), 2));
  size_of = max ([a.passed(end); abs(stored - stored(1)); range(energy(:,1))]);
  over = abs (a.balance) - rounding;
  over(over < 0) = 0;   # NaN stays
  a.error = norm (over, Inf) / max (size_of, realmin);
  if (! any ([energy(:); a.passed]))   # there is nothing that could be balanced
    a.error = NaN;
  endif
endfunction
