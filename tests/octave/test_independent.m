## The independent Newton-Euler formulation of the test suite (independent/ne_*) against the
## reference cases.

function test_independent ()
  puma ();
  slider_crank ();
  fourbar ();
  pendulum ();
  cart_pole ();
end

function puma ()
  [m, ref] = gsmbp_case ("01a_puma560_akb_3link");
  worst = zeros (1, 7);
  for s = ref.states'
    v = @(field) ne_numbers (s.(field));
    [M, c, G] = ne_terms (m, v("q"), v("qd"));
    tau = ne_inverse (m, v("q"), v("qd"), v("qdd"));
    ud = ne_forward (m, v("q"), v("qd"), v("tau"));
    [T, V] = ne_energy (m, v("q"), v("qd"));
    found = {M, c, G, tau, ud, T, V};
    wanted = cellfun (v, {"M", "c", "G", "tau_id", "qdd_fd", "kinetic", "potential"}, ...
                      "UniformOutput", false);
    worst = max (worst, cellfun (@(a, b) max (abs (a - b)(:)) / max (abs (b(:))), found, wanted));
  end
  ## measured 1e-15 to 1e-14; qdd multiplies by the condition of M, a few hundred
  names = {"M", "c", "G", "tau", "qdd", "kinetic energy", "potential energy"};
  for k = 1:7
    gsmbp_check (["01a " names{k}], worst(k), 1e-12);
  end
end

function slider_crank ()
  [m, ~, tab] = gsmbp_case ("02a_slidercrank_inverse");
  n = numel (tab.t);
  tau = zeros (n, 1);
  pin = zeros (n, 2);
  for i = 1:n
    guess = [tab.theta(i); tab.phi_rod(i) - tab.theta(i); tab.x_slider(i) - 0.85];
    [q, u, ud] = ne_close (m, guess, 1, [tab.omega(i); 0; 0], [tab.alpha(i); 0; 0]);
    [efforts, pin(i, :)] = ne_inverse (m, q, u, ud, 1);
    tau(i) = efforts(1);
    geometry(i, :) = [q(1) + q(2) - tab.phi_rod(i), q(3) + 0.85 - tab.x_slider(i), ...
                      u(3) - tab.v_slider(i), ud(3) - tab.a_slider(i)];
  end
  gsmbp_check ("02a positions, slider speed and acceleration", geometry, 1e-12);
  gsmbp_check ("02a drive torque", (tau - tab.torque) / max (abs (tab.torque)), 1e-12);
  gsmbp_check ("02a pin force", ...
               (pin ...
                  - [tab.pin_fx_on_slider, ...
                     tab.pin_fy_on_slider]) / max (abs (tab.pin_fy_on_slider)), 1e-12);
end

function fourbar ()
  [m, ~, tab] = gsmbp_case ("03a_fourbar");
  for i = 1:numel (tab.t)
    guess = [tab.theta(i); tab.phi_coupler(i) - tab.theta(i); tab.psi_rocker(i)];
    [q, u] = ne_close (m, guess, 1, [tab.omega(i); 0; 0], zeros (3, 1));
    [ud, lam(i, :)] = ne_forward (m, q, u, zeros (3, 1));
    [T, V] = ne_energy (m, q, u);
    found(i, :) = [ud(1), T + V];
  end
  gsmbp_check ("03a crank acceleration", (found(:, 1) - tab.alpha) / max (abs (tab.alpha)), 1e-12);
  gsmbp_check ("03a energy", found(:, 2) - tab.energy, 1e-12);
  gsmbp_check ("03a loop force", ...
               (lam - [tab.lam_x, tab.lam_y]) / max (abs ([tab.lam_x; tab.lam_y])), 1e-12);
end

function pendulum ()
  [m, ~, tab] = gsmbp_case ("07c_spatial_triple_pendulum");
  q = [tab.q1, tab.q2, tab.q3];
  u = [tab.d_q1, tab.d_q2, tab.d_q3];
  wanted = [tab.dd_q1, tab.dd_q2, tab.dd_q3];
  for i = 1:rows (q)
    ud(i, :) = ne_forward (m, q(i, :), u(i, :), zeros (3, 1));
    [T, V] = ne_energy (m, q(i, :), u(i, :));
    energy(i, 1) = T + V;
  end
  gsmbp_check ("07c accelerations", (ud - wanted) / max (abs (wanted(:))), 1e-12);
  gsmbp_check ("07c energy", energy - tab.energy, 1e-12);
end

function cart_pole ()
  [m, ref] = gsmbp_case ("15a_cart_pole_linear");
  ## central differences, step 1e-4 in the angle: error 1e-8 of the largest entry by the third
  ## derivative, 1e-11 by Richardson's combination
  rhs = @(x, F) [x(3:4); ne_forward(m, x(1:2), x(3:4), [F; 0])];
  for place = {"upright", "hanging"}
    x = [0; pi * strcmp(place{1}, "hanging"); 0; 0];
    D = @(h) cell2mat (arrayfun (@(k) rhs (x + h * (1:4 == k)', 0) ...
                                   - rhs (x - h * (1:4 == k)', 0), 1:4, "UniformOutput", ...
                                 false)) / (2 * h);
    A = (4 * D(5e-4) - D(1e-3)) / 3;
    B = rhs (x, 0.5) - rhs (x, -0.5);
    wanted = ref.values.(place{1});
    gsmbp_check (["15a A " place{1}], (A - ne_numbers (wanted.A)) / 21, 1e-11);
    gsmbp_check (["15a B " place{1}], B - ne_numbers (wanted.B), 1e-12);
  end
end
