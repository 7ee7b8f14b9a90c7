## A slider-crank with a rod that bends, against Lagrange's equations in the crank's angle and the
## amplitudes of the rod, whose integrals are sums over Gauss points and whose derivatives are
## complex steps (independent/fx_slider_crank.m): its motion, and the rigid mechanism to which it
## comes as the rod becomes stiff.

function test_flexible_loops ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "independent"));
  m = gsmbp_fixture ("flexible_slider_crank");
  history (m);
  rigid_limit (m);
end

## more than half a turn, the rod let go bent by 14 mm; lsode by Adams' formulas
function history (m)
  p = fx_slider_crank (m.par);
  x0 = gsmbp_assemble (m, [0; 0; m.par.l1 + m.par.l2; 0.01; 0; 20; 0; 0; 0; 0], ...
                       "hold", {"q1", "rod_1", "rod_2"});
  t = linspace (0, 0.3, 31);
  run = gsmbp_simulate (m, x0, t, "rtol", 1e-12, "atol", 1e-13);
  lsode_options ("integration method", "adams");
  lsode_options ("relative tolerance", 1e-12);
  lsode_options ("absolute tolerance", 1e-13);
  z = lsode (@(z, t) [z(4:6); p.accelerations(z(1:3), z(4:6))], x0([1, 4:6, 9:10]), t)';
  for k = 1:numel (t)
    x(k,:) = p.state (z(1:3,k), z(4:6,k))';
  end
  far = max (abs (x));
  gsmbp_check ("slider-crank, bent rod: coordinates and speeds, of the largest of each", ...
               (run.x - x) ./ far, 1e-8);
  gsmbp_check ("slider-crank, bent rod: it turns and bends", ...
               all (far([1, 4, 5]) > [pi, 0.009, 4e-4]));
end

## The modes where the rod is in balance: the acceleration of the crank against that of the rigid
## mechanism falls as 1/EI over four decades.
function rigid_limit (m)
  p = fx_slider_crank (m.par);
  [a, ad] = deal (0.8, 20);
  rigid = p.rigid (a, ad);
  for k = 1:5
    EI = 10 ^ (k + 2);
    f = fx_slider_crank (setfield (m.par, "EI", EI));
    [z, away] = balance (gsmbp_set (m, "EI", EI), f, a, ad);
    left(k) = away;
    off(k) = z - rigid;
  end
  gsmbp_check ("slider-crank, stiff rod: the modes are in balance, rad/s^2", left, 1e-8);
  gsmbp_check ("slider-crank, stiff rod: each decade is a tenth of the error", ...
               (off(1:4) ./ off(2:5) / 10 - 1) .* [1, 10, 100, 100], 3e-4);
  gsmbp_check ("slider-crank, stiff rod: there is an error to fall", ...
               abs (off(1) / rigid) > 1e-6);
end

## the acceleration of the crank where those of the modes vanish, by Newton's method; what is left
## of them
function [acceleration, left] = balance (m, f, a, ad)
  modal = @(x) x(9:10);
  at = @(b) modal (m.rhs (0, f.state ([a; b], [ad; 0; 0])));
  b = zeros (2, 1);
  for k = 1:4
    h = 1e-4;
    slope = [at(b + [h; 0]) - at(b - [h; 0]), at(b + [0; h]) - at(b - [0; h])] / (2 * h);
    b -= slope \ at (b);
  end
  xd = m.rhs (0, f.state ([a; b], [ad; 0; 0]));
  [acceleration, left] = deal (xd(6), max (abs (xd(9:10))));
end
