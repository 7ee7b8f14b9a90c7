## gsmbp_optimize: choices from lists by branch and bound, held against all combinations.

function test_optimize_choices ()
  if (! gsmbp_has_nlopt () || ! gsmbp_has_ipopt ())
    printf ("ok left out: libnlopt-dev or coinor-libipopt-dev is not installed\n");
    return;
  end
  m = gsmbp_set (gsmbp_fixture ("design_lamp"), "k", 0);
  counterweight (m);
  with_spring (gsmbp_fixture ("design_lamp"));
  limits_and_conflicts (m);
end

## a weight and an arm from 50 x 40 numbers, lightest beside the arm's price, effort below 0.5
function counterweight (m)
  [mc, lc] = deal (0.3 + 0.13 * (0:49), 0.05 + 0.0137 * (0:39));
  free = {"mc", 1, num2cell(mc); "lc", 0.1, num2cell(lc)};
  goal = {"mass", "weight", 1; "value", "lc", 8};
  still = {"positions", "q", 0};
  r = gsmbp_optimize (m, free, goal, {"peak", "effort.q", "<", 0.5}, still);
  [A, B] = ndgrid (mc, lc);
  J = A + 8 * B;
  J(abs (2 * 0.4 - A .* B) * 9.81 > 0.5) = Inf;
  [least, k] = min (J(:));
  gsmbp_check (sprintf ("branch and bound finds the best of 2000 by %d problems: %.9g", ...
                        r.choices.solved, r.J), abs (r.J - least) < 1e-9 ...
               && r.values.mc == A(k) && r.values.lc == B(k) && r.solved);
  gsmbp_check ("in fewer than a tenth", strcmp (r.choices.how, "branch") ...
               && r.choices.solved < 200 && ! isempty (strfind (r.report, "branch and bound, ")));
end

## two choices beside a continuous variable, both ways
function with_spring (m)
  free = {"mc", 1, num2cell(0.2:0.7:3); "h", 0.3, num2cell(0.1:0.14:0.8); "k", 50, [1 1000]};
  goal = {"value", "k", 0.01; "value", "h", 2; "mass", "weight", 1};
  demands = {"peak", "effort.q", "<", 0.01};
  still = {"positions", "q", [-1; 0; 1]};
  one = gsmbp_optimize (m, free, goal, demands, still, "choices", "branch");
  all_ = gsmbp_optimize (m, free, goal, demands, still, "choices", "all", "solver", "slsqp");
  near = abs (one.J - all_.J);
  gsmbp_check (sprintf ("the same as all combinations, within 1e-6, found %.2g, %d of %d", near, ...
                        one.choices.solved, all_.choices.solved), near < 1e-6 ...
               && one.values.mc == all_.values.mc && one.values.h == all_.values.h);
end

function limits_and_conflicts (m)
  free = {"mc", 1, num2cell(linspace (0.1, 5, 60)); "lc", 0.1, num2cell(linspace (0.01, 0.4, 60))};
  still = {"positions", "q", 0};
  demands = {"peak", "effort.q", "<", 0.5};
  [r, info] = gsmbp_optimize (m, free, {"mass", "weight", 1; "value", "lc", 8}, demands, ...
                              still, ...
                              "nodes", 12);
  gsmbp_check (["a limit says so: " r.ended], info == 1 && r.limit ...
               && ! isempty (strfind (r.ended, "other choices may reach")));
  [r, info] = gsmbp_optimize (m, free, {"mass", "weight"}, ...
                              [demands; {"mass", "weight", "<", 1}], still);
  gsmbp_check (["no combination can: " r.ended], info == 2 && numel (r.conflict) == 2);
  few = {"mc", 0.5, {0.5, 1.5}; "lc", 0.2, {0.2, 0.7}};
  [r, info] = gsmbp_optimize (m, few, {"mass", "weight"}, {"peak", "effort.q", "<", 0.5}, still, ...
                              "choices", "branch");
  gsmbp_check (["none of four can, though a number between could: " r.ended], info == 2 ...
               && ! isempty (strfind (r.ended, "of all choices with mc = 1.5, lc = 0.7")));
  r = gsmbp_optimize (m, {"mc", 1, {1, 2, 3}}, {"value", "mc", -1}, {"mass", "weight", "<", 2});
  gsmbp_check ("a demand that is met with nothing to spare, all chosen: no multiplier", ...
               r.values.mc == 2 && isnan (r.active.multiplier));
  text = gsmbp_complaint (@() gsmbp_optimize (m, free, {"mass", "weight"}, demands, still, ...
                                              "choices", "all"));
  gsmbp_check (["refused: " text], ! isempty (strfind (text, "found 3600")));
end
