## s = gs.run.named_statistics (s, m, result, method, all)
## The statistics of a run of the model M by METHOD, as gsmbp_simulate returns them, added to those
## in S.  ALL: as the module returns them (share/engine/core/gsmbp/statistics.h).

function s = named_statistics (s, m, result, method, all)
  for name = {"calls", "accepted", "rejected", "repeated", "projections", "rank_losses", ...
              "singular_positions", "loose", "least_pivot", "least_pivot_at", ...
              "angle_singularities", "partition_changes", "jacobians", "newton", ...
              "smallest_step", "largest_step", "reached"}
    s.(name{1}) = all.(name{1});
  endfor
  s.rank_loss_times = [all.first_rank_loss, all.last_rank_loss];
  s.singular_times = [all.first_singular, all.last_singular];
  s.angle_times = [all.first_angles, all.last_angles];
  s.method = method;
  s.jacobians *= any (strcmp (method, {"cvode", "radau"}));
  s.newton *= any (strcmp (method, {"cvode", "radau", "gauss"}));
  s.stiff = stiffness (m, all);
  s.drift = struct ("phi", all.phi, "phidot", all.phidot, "phi_at", all.phi_at, "phidot_at", ...
                    all.phidot_at, "before_projection", all.before_projection);
  s.margins = gs.start.range_margins (m, result.t, result.x, result.v);
endfunction

## of derivatives, behind the states, it is that of their state: their columns have its eigenvalues
function s = stiffness (m, all)
  s = struct ("time", NaN, "eigenvalue", NaN, "state", "", "step", NaN);
  if (all.stiff)
    s = struct ("time", all.stiff_at, "eigenvalue", all.stiff_eigenvalue, ...
                "state", m.states{mod(all.stiff_state - 1, m.sizes.nx) + 1}, ...
                "step", all.stiff_step);
  endif
endfunction
