## [full, less, truth] = choose_runs (M_FULL, M_LESS): the same voltages, those that the full motors
## need for the quintic of examples/puma560, given to both models through a spline of ten pieces:
## handles run (rtol, method) with the result of gsmbp_simulate at 21 times, and the full model's
## motion at a tight tolerance.

function [full, less, truth] = choose_runs (m_full, m_less)
  plan = gsmbp_plan ("quintic", [0.5, 0; -0.75, 0; 0.5, 0], [0, 1]);
  t = linspace (0, 1, 11)';   # few pieces: the integration stops at every break
  r = gsmbp_inverse (m_full, plan, t);
  r.v(end,:) = gsmbp_inverse (m_full, plan, 1, "side", -1).v;
  v = gsmbp_plan ("table", t, r.v, 3);
  ## inputs v1, v1_d, v2, ... of the reduced motors: the spline and its derivative, in one table
  c = zeros (v.pieces, v.order, 6);
  given = permute (reshape (v.coefs, 3, v.pieces, v.order), [2 3 1]);
  c(:,:,1:2:5) = given;
  c(:,2:end,2:2:6) = given(:,1:end-1,:) .* (v.order-1:-1:1);
  both = mkpp (v.breaks, reshape (permute (c, [3 1 2]), 6 * v.pieces, v.order), 6);
  times = linspace (0, 1, 21);
  full = @(rtol, method) gsmbp_simulate (m_full, r.x(1,:)', times, "input", v, "rtol", rtol, ...
      "method", method);
  less = @(rtol, method) gsmbp_simulate (m_less, r.x(1,1:6)', times, "input", both, "rtol", ...
      rtol, "method", method);
  truth = full (1e-11, "dp853").x(:,1:3);
end
