## Controllers for an upright cart-pole (reference D6a: 50 digits), designed on the exact linear
## model of the scene: LQR, Kalman filter, LQG, poles, zero-order hold, delay.

function test_reference_cart_pole_control ()
  pkg load control
  m = gsmbp_fixture ("case_d6a");
  [~, all_] = gsmbp_case ("D6a_cartpole");
  ref = all_.systems.cartpole;
  e = gsmbp_trim (m, m.initial, 0, "hold", "x");
  names = {"position", "angle", "speed", "rate"};
  two = names(1:2);
  c = gsmbp_control (m, e, "lqr", "measured", names);
  gsmbp_check ("A and B of the scene", [c.plant.a - numbers(ref.A), c.plant.b - numbers(ref.B)], ...
               1e-13);
  gsmbp_check ("LQR: gain", relative (c.K, ref.lqr.K), 1e-12);
  found = sort (poles (ref.lqr.closed_loop_poles));
  gsmbp_check ("LQR: poles", relative (sort (c.poles), found), 1e-12);
  c = gsmbp_control (m, e, "lqg", "measured", two, "W", 0.01, "V", 1e-4);
  gsmbp_check ("LQG: gain", relative (c.K, ref.lqr.K), 1e-12);
  gsmbp_check ("Kalman filter: gain", relative (c.L, ref.kalman.L), 1e-12);
  both = sort ([poles(ref.lqr.closed_loop_poles); poles(ref.kalman.observer_poles)]);
  gsmbp_check ("LQG: poles of both together", relative (sort (c.poles), both), 1e-9);
  gsmbp_check ("LQG: cost", cost (c, 0.01, 1e-4) / str2double (ref.lqg.cost) - 1, 1e-10);
  c = gsmbp_control (m, e, "place", "measured", names, "poles", [-3+2i, -3-2i, -5, -6]);
  gsmbp_check ("poles placed: gain", relative (c.K, ref.place.K), 1e-11);
  c = gsmbp_control (m, e, "lqr", "measured", names, "period", 0.01);
  gsmbp_check ("zero-order hold", ...
               [relative(c.plant.a, ref.zoh.Ad), relative(c.plant.b, ref.zoh.Bd)], 1e-14);
  gsmbp_check ("sampled LQR: gain", relative (c.K, ref.zoh.dlqr_K), 1e-8);
  gsmbp_check ("sampled LQR: poles", ...
               relative (sort (c.poles), sort (poles (ref.zoh.dlqr_poles))), 1e-8);
  c = gsmbp_control (m, e, "lqr", "measured", names, "period", 0.01, "delay", 0.004);
  gsmbp_check ("delay: inputs old and new", ...
               [relative(c.plant.b(1:4), ref.delayed.G0); ...
                relative(c.plant.a(1:4,5), ref.delayed.G1)], 1e-13);
  K = numbers (ref.lqr.K);
  found = eig (c.plant.a - c.plant.b * [K, 0]);
  gsmbp_check ("delay: poles with the continuous gain", ...
               relative (sort (found), sort (poles (ref.delayed.poles_with_continuous_K))), 1e-11);
end

function M = numbers (list)
  if (ischar (list{1}))
    M = str2double (list)(:)';
    return;
  end
  M = cell2mat (cellfun (@(row) str2double (row)(:)', list(:), "UniformOutput", false));
end

function r = relative (found, list)
  if (iscell (list))
    list = numbers (list);
  end
  if (numel (found) == numel (list) && ! isequal (size (found), size (list)))
    list = reshape (list, size (found));
  end
  r = max (max (abs (found - list))) / max (max (abs (list)));
end

function p = poles (list)
  M = numbers (list);
  p = M(:,1) + 1i * M(:,2);
end

## E[x'x + u'u] of the closed loop under noise of W on the states and V on the measurements
function J = cost (c, W, V)
  [A, ~, C] = gsmbp_closed_of (c);
  n = rows (c.plant.a);
  N = blkdiag (W * eye (n), c.B * V * c.B');
  P = lyap (A, N);
  J = trace (P(1:n,1:n)) + trace (c.C * P(n+1:end,n+1:end) * c.C');
end

function [A, B, C] = gsmbp_closed_of (c)
  [F, H, S] = deal (c.plant.a, c.plant.b, c.plant.c);
  A = [F + H * c.D * S, H * c.C; c.B * S, c.A];
  B = [];
  C = [];
end
