## GSPLN of the run time against gsmbp_evaluate and closed forms; one-sided limits, ends, tables.

function test_planners ()
  f = gsmbp_hand ("motor_pendulum").module;
  rand ("seed", 2);
  pp = mkpp ([0, 0.3, 1, 2.5], rand (2 * 3, 6) - 0.5, 2);
  t = [-1, -1e-13, 0, 0.1, 0.3, 0.7, 1, 1.9, 2.5, 2.5 + 1e-13, 3];
  for side = [-1, 1]
    found = evaluate (f, pp, t, 4, side);
    wanted = permute (gsmbp_evaluate (pp, t, 4, side), [1, 3, 2]);
    gsmbp_check (sprintf ("GSPLN against Octave, four derivatives, limit from side %d", side), ...
                 found - wanted, 1e-12);
  end
  gsmbp_check ("GSPLN against ppval", ...
               squeeze (evaluate (f, pp, t(3:8), 0, 1)) - ppval (pp, t(3:8)), 1e-14);
  [~, outside] = evaluate (f, pp, 3, 0, 1);
  gsmbp_check ("GSPLN tells that the time is outside", outside == 1);

  ## rest at both ends: the quintic to the acceleration, the septic to the jerk
  for [zeros_at_ends, kind] = struct ("quintic", 2, "septic", 3)
    plan = gsmbp_plan (kind, [0.5, 0; -0.75, 1], [0.2, 1.7]);
    ends = evaluate (f, plan, [0.2, 1.7], zeros_at_ends, 1);
    gsmbp_check ([kind, " ends at rest"], ends(:,2:end,:), 1e-11);
    gsmbp_check ([kind, " meets its ends"], squeeze (ends(:,1,:)) - [0.5, 0; -0.75, 1], 1e-13);
    h = 1e-3;
    jump = evaluate (f, plan, [0.2 + h, 0.2 + h / 2], zeros_at_ends, 1);
    gsmbp_check ([kind, " leaves rest with a derivative of the next order"], ...
                 log2 (jump(1,end,1) / jump(1,end,2)) - 1, 0.01);
  end

  ## the velocity profile of the paper's figure 7: acceleration triangle, peak 4 rad/s^2 at 1 s
  plan = gsmbp_plan ("profile", mkpp ([0, 1, 2, 6], [4, 0; -4, 4; 0, 0]), 2);
  speed = @(t) evaluate (f, plan, t, 1, 1)(1,2,:)(:)';
  gsmbp_check ("profile of figure 7: speeds", ...
               speed ([0, 0.5, 1, 1.5, 2, 6]) - [0, 0.5, 2, 3.5, 4, 4], 1e-15);
  kinks = [evaluate(f, plan, 1, 3, -1)(1,4), evaluate(f, plan, 1, 3, 1)(1,4)];
  gsmbp_check ("profile of figure 7: jerk on both sides of 1 s", kinks - [4, -4], 1e-15);

  ## order of interpolation of tables: error of a sine falls with h^(order+1), 1 for order 0
  for order = [0, 1, 3]
    for k = 1:2
      h = 0.1 / 2^k;
      s = (0:h:2)';
      fine = 0.2:0.00137:1.8;
      e(k) = max (abs (squeeze (evaluate (f, gsmbp_plan ("table", s, sin (s), order), fine, 0, ...
                                  1))' - sin (fine)));
    end
    gsmbp_check (sprintf ("table of order %d: order of the error, less what is expected", ...
                          order), log2 (e(1) / e(2)) - [1, 2, NaN, 4](order + 1), 0.15);
  end
end

function [y, outside] = evaluate (f, pp, t, nd, side)
  [y, outside] = f ("spline", [prod(pp.dim), pp.pieces, pp.order, nd, side], pp.breaks, ...
                    reshape (pp.coefs, prod (pp.dim) * pp.pieces, pp.order), t);
end
