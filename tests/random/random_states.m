## [states, reason] = random_states (M, COUNT): states of a mechanism of random_scene drawn by
## chance: structs t, q, u, ud; u obeys all constraints, ud is free; loop_q, loop_u: of the loop
## joints' own freedoms. REASON: empty, or why there is none (a loop that does not close away from
## its start, say).

function [states, reason] = random_states (m, count)
  states = [];
  reason = "";
  tree = isempty (m.loop) && isempty (m.user);
  n = numel (m.u);
  reach = 0.6 + 3.4 * strcmp (m.kind, "parallel");          # screws over more than one turn
  for i = 1:count
    for draw = 1:8
      t = m.start_time + (rand - 0.5) * ! tree;
      if (tree)
        q = ne_advance (m, m.start, 2 * (2 * rand (n, 1) - 1));
        left = 0;
      else
        [q, left] = ne_assemble (m, ...
                                 ne_advance (m, m.start, reach / draw * (2 * rand (n, 1) - 1)), ...
                                 t);
      end
      if (left < 1e-12)
        break;
      end
    end
    if (left >= 1e-12)
      reason = sprintf ("the loops do not close away from the start (gap %.0e left)", left);
      return;
    end
    u = 4 * rand (n, 1) - 2;
    k = ne_rows (m, q, "still", t);
    H = ne_jacobian (k);
    if (rows (H))
      u -= pinv (H, 1e-9 * max (1, norm (H))) * (H * u - [zeros(rows (k.L), 1); k.rate_user]);
    end
    states = [states, ...
              struct("t", t, "q", q, "u", u, "ud", 4 * rand(n, 1) - 2, "loop_q", [], "loop_u", ...
                     [])];
    [states(end).loop_q, states(end).loop_u] = ne_own (m, ne_rows (m, q, u, t));
  end
end
