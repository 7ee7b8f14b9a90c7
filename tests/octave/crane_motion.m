## d = crane_motion (t)
## The scene ident_crane with other parameters in an exciting motion, from equations of motion
## written by hand: exact q, u, ud, tau at the times T (a column), p, the base parameters (mR, hx,
## hy, Izz, friction of the rail and of the pin), names of these, and bound (sigma_q, sigma_tau),
## the Cramer-Rao bound of their covariance where positions and efforts at T have noise of these
## standard deviations and the motion is known to be a Fourier series of three harmonics. The
## coefficients of the series are those of gsmbp_excite (m, "speed", [1 3], "acceleration", [4 10],
## "period", 5, "harmonics", 3, "sigma", [1 0.2]).

function d = crane_motion (t)
  series = [0.035467538930454734, 0.20099435785923078, 0.13195417801202877, ...
            -0.15496757129442937, 0.10730501008481876, 0.07347476933339879, ...
            -0.044578231935379332
            -0.15750735456218073, 0.81212796837510037, -0.090300787149852568, ...
            -0.21050879802513156, 0.65075243888100631, -0.028772129604396252, ...
            -0.059518213384824555]';
  d.t = t;
  d.p = [7.1 + 3.6; 0; -3.6*0.38; 0.06 + 3.6*0.38^2; 9.5; 0.3];
  d.names = {"trolley_mR"; "arm_hx"; "arm_hy"; "arm_Izz"; "rail_friction"; "pin_friction"};
  [d.tau, d.q, d.u, d.ud] = efforts (t, d.p, series);
  d.bound = @(sigma_q, sigma_tau) bound (t, d.p, series, sigma_q, sigma_tau);
end

function [tau, q, u, a] = efforts (t, p, series)
  w = 2*pi/5 * (1:3);
  [S, C, o] = deal (sin (t*w), cos (t*w), zeros (size (t)));
  q = [o + 1, S, C] * series;
  u = [o, C.*w, -S.*w] * series;
  a = [o, -S.*w.^2, -C.*w.^2] * series;
  x = cos (q(:,2))*p(2) - sin (q(:,2))*p(3);    # moment of mass along x and y
  y = sin (q(:,2))*p(2) + cos (q(:,2))*p(3);
  F = p(1)*a(:,1) - a(:,2).*y - u(:,2).^2.*x + p(5)*u(:,1);
  M = p(4)*a(:,2) - y.*a(:,1) + 9.81*x + p(6)*u(:,2);
  tau = [F, M];
end

## the inverse of the Fisher information of parameters and series, by complex steps
function C = bound (t, p, series, sigma_q, sigma_tau)
  z0 = [p; series(:)];
  for k = 1:numel (z0)
    z = z0;
    z(k) += 1e-30i;
    [tau, q] = efforts (t, z(1:6), reshape (z(7:end), 7, 2));
    J(:,k) = imag ([q ./ sigma_q, tau ./ sigma_tau](:)) / 1e-30;
  end
  scale = 1 ./ norm (J, "columns");
  [~, R] = qr (J .* scale, 0);
  C = inv (R) .* scale';
  C = (C * C')(1:6,1:6);
end
