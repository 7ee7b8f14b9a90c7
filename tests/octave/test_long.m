## A million steps of a spatial loop (crank, rod on a universal and a ball joint, rocker): classical
## Runge-Kutta, 1 ms, no drive.

function test_long ()
  m = gsmbp_set (gsmbp_fixture ("close_spherical"), "tau", 0);
  x0 = gsmbp_assemble (m, [0.4; 0.5; -0.5; 0.3; 8; 0; 0; 0], "hold", {"theta"});
  E = @(x) sum (m.ene (0, x)(1:2));
  run = gsmbp_simulate (m, x0, [0, 500, 1000], "method", "rk4", "step", 1e-3);
  printf ("   (%.0f turns)\n", run.x(end, 1) / (2 * pi));
  gsmbp_check ("1e6 steps of a spatial loop", run.stats.accepted == 1e6);
  ## projected after each step: what Newton leaves
  gsmbp_check ("1e6 steps of a spatial loop: drift, m", run.stats.drift.phi, 1e-11);
  gsmbp_check ("1e6 steps of a spatial loop: drift of the speeds, m/s", run.stats.drift.phidot, ...
               1e-11);
  gsmbp_check ("1e6 steps of a spatial loop: energy, relative", ...
               [E(run.x(2, :)'), E(run.x(3, :)')] / E (x0) - 1, 1e-5);
end
