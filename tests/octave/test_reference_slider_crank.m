## Slider-crank on the velocity profile of the paper's figure 7: motion, drive torque, pin force,
## motor current and voltage.

function test_reference_slider_crank ()
  [~, ~, tab] = gsmbp_case ("02a_slidercrank_inverse");
  statics (tab);
  motor (tab);
end

## the rest of the motion from the constraints: HC u + PHIT = 0, HC u' = GAM, the crank given
function [q, u, ud] = motion (m, tab, i)
  q = [tab.theta(i); tab.phi_rod(i) - tab.theta(i); tab.x_slider(i) - 0.85];
  [~, phit, H] = m.con (0, q, zeros (3, 1));
  u = [tab.omega(i); H(:, 2:3) \ (-phit - H(:, 1) * tab.omega(i))];
  [~, ~, ~, gam] = m.con (0, q, u);
  ud = [tab.alpha(i); H(:, 2:3) \ (gam - H(:, 1) * tab.alpha(i))];
end

function statics (tab)
  m = gsmbp_fixture ("case_02a");
  for i = 1:numel (tab.t)
    [q, u, ud] = motion (m, tab, i);
    gap(i, :) = m.con (0, q, u);
    moves(i, :) = [u(3) - tab.v_slider(i), ud(3) - tab.a_slider(i)];
    xd = m.rhs (0, [q; u], tab.torque(i));
    alpha(i, 1) = xd(4);
  end
  gsmbp_check ("slider_crank: loop closed at the reference positions, m", gap, 1e-15);
  gsmbp_check ("slider_crank: slider speed and acceleration", ...
               moves ./ max (abs ([tab.v_slider, tab.a_slider])), 1e-13);
  gsmbp_check ("slider_crank: crank acceleration under the reference torque", ...
               (alpha - tab.alpha) / max (abs (tab.alpha)), 1e-13);
end

function motor (tab)
  m = gsmbp_fixture ("case_02a_motor");
  J = 0.012; B = 0.015; K = 0.65;
  jerk = 4 * (tab.t < 1) - 4 * (tab.t >= 1 & tab.t < 2);
  for i = 1:numel (tab.t)
    [q, u, ud] = motion (m, tab, i);
    [taua, pin] = m.inl (0, q, u, ud, 0);
    current(i, 1) = taua / K;
    lam(i, :) = pin;
    qj = m.clo (0, [q, [tab.omega(i); 0; 0], [tab.alpha(i); 0; 0], [jerk(i); 0; 0]]);
    voltage(i, 1) = m.cmd (0, qj, []);
  end
  torque = K * current - J * tab.alpha - B * tab.omega;
  scaled = @(found, wanted) (found - wanted) / max (abs (wanted));
  gsmbp_check ("slider_crank: drive torque", scaled (torque, tab.torque), 1e-13);
  gsmbp_check ("slider_crank: pin force on the slider", ...
               scaled (lam, [tab.pin_fx_on_slider, tab.pin_fy_on_slider]), 1e-13);
  gsmbp_check ("slider_crank: motor current", scaled (current, tab.current), 1e-13);
  regular = ! isnan (tab.voltage);
  gsmbp_check ("slider_crank: motor voltage", ...
               scaled (voltage(regular), tab.voltage(regular)), 1e-13);
end
