## s = gsmbp__run_stats (s, m, result, method, counts, values)
## The statistics of a run of the model M by METHOD, as gsmbp_simulate tells them, beside what S has
## already.  COUNTS, VALUES: ISTAT and RSTAT of share/fortran/integrate/gssim.f.

function s = gsmbp__run_stats (s, m, result, method, counts, values)
  s.calls = counts(1);
  s.accepted = counts(2);
  s.rejected = counts(3);
  s.repeated = counts(12);
  s.projections = counts(4);
  s.rank_losses = counts(8);
  s.rank_loss_times = values(10:11)';
  s.singular_positions = counts(11);
  s.singular_times = values(16:17)';
  s.loose = counts(20);
  s.least_pivot = values(14);
  s.least_pivot_at = values(15);
  s.angle_singularities = counts(9);
  s.angle_times = values(12:13)';
  s.partition_changes = counts(10);
  s.method = method;
  s.jacobians = counts(16) * any (strcmp (method, {"cvode", "radau"}));
  s.newton = counts(17) * any (strcmp (method, {"cvode", "radau", "gauss"}));
  s.stiff = stiffness (m, counts, values);
  s.smallest_step = values(6);
  s.largest_step = values(7);
  s.drift = struct ("phi", values(1), "phidot", values(2), "phi_at", values(3), "phidot_at", ...
                    values(4), "before_projection", values(5));
  s.reached = values(8);
  s.margins = gsmbp__margins (m, result.t, result.x, result.v);
endfunction

## of derivatives, behind the states, it is that of their state: their columns have its eigenvalues
function s = stiffness (m, counts, values)
  s = struct ("time", NaN, "eigenvalue", NaN, "state", "", "step", NaN);
  if (counts(14) > 0)
    state = m.states{mod (counts(15) - 1, m.sizes.nx) + 1};
    s = struct ("time", values(18), "eigenvalue", values(19), "state", state, "step", values(20));
  endif
endfunction
