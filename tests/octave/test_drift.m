## A million steps: the slider-crank started at 12 rad/s and left free, classical Runge-Kutta, 1 ms. The bounds are the issue's.

function test_drift ()
  m = gsmbp_fixture ("free_crank");
  x0 = gsmbp_assemble (m, [0; 0; 0.7; 12; 0; 0], "hold", {"q1"});
  gsmbp_check ("start: the crank keeps its speed", x0(4) - 12, 1e-14);
  start = energy (m, x0);
  for way = {"Baumgarte, alpha = beta = 5/s", false, 1e-9; "projection", true, 1e-12}'
    run = gsmbp_simulate (m, x0, [0, 1000], "method", "rk4", "step", 1e-3, "projection", way{2});
    gsmbp_check (["1e6 steps are 1e6 steps, " way{1}], run.stats.accepted == 1e6);
    gsmbp_check (["drift of the loop in m over 1e6 steps, " way{1}], run.stats.drift.phi, way{3});
    ## 5e-7 of the energy is what RK4 loses at this step (shared table of the long runs: 2.5e-7 and 3.5e-7)
    gsmbp_check (["energy lost over 1e6 steps, " way{1}], energy (m, run.x(end, :)') / start - 1, 1e-6);
  end
end

function e = energy (m, x)
  E = m.ene (0, x);
  e = E(1) + E(2);
end
