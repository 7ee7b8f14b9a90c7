## A million steps: the slider-crank started at 12 rad/s and left free, classical Runge-Kutta, 1 ms.

function test_drift ()
  m = gsmbp_fixture ("free_crank");
  x0 = gsmbp_assemble (m, [0; 0; 0.7; 12; 0; 0], "hold", {"q1"});
  gsmbp_check ("start: the crank keeps its speed", x0(4) - 12, 1e-14);
  start = energy (m, x0);
  ## energy: RK4 alone loses about 1e-7 of it in 1000 s at this step; Baumgarte's terms do some work
  ## of their own
  for way = {"Baumgarte, alpha = beta = 5/s", false, 1e-9, 1e-5; "projection", true, 1e-12, 1e-6}'
    run = gsmbp_simulate (m, x0, [0, 1000], "method", "rk4", "step", 1e-3, "projection", way{2});
    gsmbp_check (["1e6 steps are 1e6 steps, " way{1}], run.stats.accepted == 1e6);
    gsmbp_check (["drift of the loop in m over 1e6 steps, " way{1}], run.stats.drift.phi, way{3});
    gsmbp_check (["energy lost over 1e6 steps, " way{1}], ...
                 energy (m, run.x(end, :)') / start - 1, way{4});
  end
end

function e = energy (m, x)
  E = m.ene (0, x);
  e = E(1) + E(2);
end
