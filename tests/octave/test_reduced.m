## Linear models of closed chains in independent coordinates, and equilibria: reference 03a, and
## differences of the closed motion itself.

function test_reduced ()
  m = gsmbp_fixture ("case_03a");
  [~, ref] = gsmbp_case ("03a_fourbar");
  number = @(field) ne_numbers (ref.linearization.(field));
  wanted = [number("theta_eq"); number("phi_eq") - number("theta_eq"); number("psi_eq")];
  ## trim from a rough guess, some 0.1 rad off
  r = gsmbp_trim (m, wanted + [0.1; -0.1; 0.1], 0);
  gsmbp_check ("03a equilibrium, rad", r.x(1:3) - wanted, 1e-9);
  gsmbp_check ("03a equilibrium: accelerations left", r.ud, 1e-8);
  [phi, ~, H] = m.con (0, r.x(1:3), zeros (3, 1));
  gsmbp_check ("03a equilibrium: multipliers carry the weight", ...
               m.inv (0, r.x(1:3), zeros (3, 1), r.ud, 0) - H' * r.lambda, 1e-9);
  [sys, T, k] = gsmbp_linear (m, 0, [wanted; 0; 0; 0], 0, "reduced", "theta");
  gsmbp_check ("03a reduced states are the crank's", isequal (k, [1 4]));
  gsmbp_check ("03a reduced A", (sys.a - number("A")) / max (abs (number("A")(:))), 1e-12);
  gsmbp_check ("03a reduced B", (sys.b - number("B")(:)) / max (abs (number("B"))), 1e-12);
  auto = gsmbp_linear (m, 0, [wanted; 0; 0; 0], 0);
  gsmbp_check ("03a poles do not depend on the choice of coordinates", ...
               sort (eig (auto.a)) - sort (eig (sys.a)), 1e-10);
  along_motion (m);
  feedback ();
end

## a slider-crank with its motor: a state feedback designed on the reduced model brings a closed
## state beside the plan back to it
function feedback ()
  m = gsmbp_fixture ("case_02a_motor");
  plan = gsmbp_plan ("septic", [0.3, 1.1], [0, 1]);
  design = gsmbp_lqr (m, plan, 0:0.25:1, diag ([100, 0, 0, 1, 0, 0, 0.01]), 0.01);
  gsmbp_check ("slider-crank: three poles, those of crank and current", ...
               rows (design.poles) == 3 && all (real (design.poles(:)) < 0));
  start = gsmbp_inverse (m, plan, 0).x';
  start(1) += 0.05;
  start = gsmbp_assemble (m, start, "hold", {"theta"});
  late = @(r) abs (r.x(end,1) - 1.1);
  alone = late (gsmbp_simulate (m, start, [0, 1], "motion", plan));
  held = late (gsmbp_simulate (m, start, [0, 1], "motion", plan, "gain", design.gain, ...
                               "reference", design.reference));
  gsmbp_check (sprintf ("slider-crank: %.1e rad off at the end with feedback, %.1e without", ...
                        held, alone), held < alone / 20);
end

## in motion: the model against central differences over the closed states themselves
function along_motion (m)
  x0 = gsmbp_assemble (m, [1.1; -0.74; 1.23; 3; 0; 0], "hold", {"theta"});
  sys = gsmbp_linear (m, 0, x0, 0.7, "reduced", {"theta"});
  A = zeros (2);
  h = 1e-5;
  for k = 1:2
    for side = [-1, 1]
      guess = x0;
      guess([1, 4](k)) += side * h;
      x = gsmbp_assemble (m, guess, "hold", {"theta"}, "tolerance", 1e-12);
      xd = m.rhs (0, x, 0.7);
      A(:,k) += side * xd([1, 4]) / (2 * h);
    end
  end
  ## central differences of step 1e-5 are good to about 1e-8 here
  gsmbp_check ("03a reduced A in motion against differences", (sys.a - A) / max (abs (A(:))), 1e-7);
end
