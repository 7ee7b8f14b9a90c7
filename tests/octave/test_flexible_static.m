## Inverse dynamics with the modal coordinates in quasi-static balance (INQ) against independent
## solutions: a slider-crank against Lagrange's equations (independent/fx_slider_crank.m), spatial
## trees by Newton's method with differences on INV.

function test_flexible_static ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "independent"));
  in_a_loop ();
  along_a_motion ();
  in_a_tree ("flexible_tree", 4, [0.7; -0.4; 0.3; 0.5], [1.3; 0.8; -0.6; 0.9], [2; -1; 0.5; 3]);
  in_a_tree ("flexible_data", 3, [0.7; -0.4; 0.3], [1.3; 0.8; -0.6], [2; -1; 0.5]);
end

## the crank's angle, speed and acceleration are given
function in_a_loop ()
  m = gsmbp_fixture ("flexible_slider_crank");
  p = fx_slider_crank (m.par);
  zero = [0; 0];
  for motion = [0, 0.7, 2.5; 0, 30, 12; 0, -200, 400]
    [a, ad, add] = deal (motion(1), motion(2), motion(3));
    e = balanced (@(e) p.efforts ([a; e], [ad; zero], [add; zero])(2:3), zero);
    tau = p.efforts ([a; e], [ad; zero], [add; zero])(1);
    x = p.state ([a; e], [ad; zero]);
    guess = m.initial(1:5);
    guess(1) = a;
    if (a > 1.6)
      guess(1:3) = p.state ([a; zero], [0; zero])(1:3) + [0; 0.1; -0.05];
    end
    [q, u, ud, found, lambda_, info] = m.inq (0, guess, [ad; 5; 6; 7; 8], [add; 1; 2; 3; 4], []);
    name = sprintf ("quasi-static slider-crank, crank at %g rad: ", a);
    gsmbp_check ([name "amplitudes"], (q(4:5) - e) / max (abs (e)), 1e-10);
    gsmbp_check ([name "coordinates, speeds, INFO"], ...
                 [(q - x(1:5)) / 0.1; (u - x(6:10)) / max([1; abs(x(6:10))]); info], 1e-10);
    gsmbp_check ([name "torque on the crank, none elsewhere"], ...
                 (found - [tau; 0; 0; 0; 0]) / max (1, abs (tau)), 1e-9);
    [~, ~, H, gam] = m.con (0, q, u);
    gsmbp_check ([name "accelerations of the loop"], (H * ud - gam) / max (1, norm (gam)), 1e-12);
    gsmbp_check ([name "multipliers"], ...
                 (m.inv (0, q, u, ud, []) - H' * lambda_ - found) / max (1, norm (lambda_)), 1e-12);
  end
end

## gsmbp_inverse of a motion of the crank alone: at one instant that of INQ; the loop stays closed
function along_a_motion ()
  m = gsmbp_fixture ("flexible_slider_crank");
  plan = gsmbp_plan ("quintic", [0, 2], [0, 0.2]);
  r = gsmbp_inverse (m, plan, linspace (0, 0.2, 21));
  p = fx_slider_crank (m.par);
  [a, ad, add] = deal (r.q(9,1), r.u(9,1), r.ud(9,1));
  zero = [0; 0];
  e = balanced (@(e) p.efforts ([a; e], [ad; zero], [add; zero])(2:3), zero);
  tau = p.efforts ([a; e], [ad; zero], [add; zero]);
  gsmbp_check ("gsmbp_inverse, modes quasi-static: amplitudes", r.q(9,4:5)' - e, 1e-12);
  gsmbp_check ("gsmbp_inverse, modes quasi-static: torque", r.tau(9,1) / tau(1) - 1, 1e-9);
  for k = 1:21
    phi(:,k) = m.con (0, r.q(k,:)');
  end
  gsmbp_check ("gsmbp_inverse, modes quasi-static: the loop", phi, 1e-13);
  gsmbp_check ("gsmbp_inverse, modes quasi-static: the plan", ...
               r.q(:,1) - gsmbp_evaluate (plan, r.t)(:), 1e-14);
  said = "";
  try
    gsmbp_inverse (gsmbp_set (m, "EI", 1e-4), plan, 0.1);
  catch problem
    said = problem.message;
  end
  gsmbp_check ("gsmbp_inverse, a rod that buckles: said", ...
               ! isempty (strfind (said, "no quasi-static balance of the modes at t = 0.1 s")));
end

## joints 1 to n are given, the modal coordinates behind them follow
function in_a_tree (name, n, q, qd, qdd)
  m = gsmbp_fixture (name);
  modes = n+1:m.sizes.nu;
  zero = 0 * modes';
  at = @(e) m.inv (0, [q; e], [qd; zero], [qdd; zero], []);
  e = balanced (@(e) at (e)(modes), zero);
  [qs, us, as, tau, info] = m.inq (0, [q; zero], [qd; zero + 7], [qdd; zero + 9], []);
  name = ["quasi-static " name ": "];
  gsmbp_check ([name "modal coordinates, of the largest"], (qs(modes) - e) / max (abs (e)), 1e-11);
  gsmbp_check ([name "they bend"], max (abs (e)) > 1e-3);
  gsmbp_check ([name "motion given"], ...
               isequal ([qs(1:n); us; as; info], [q; qd; zero; qdd; zero; 0]));
  gsmbp_check ([name "efforts of the joints"], ...
               [tau(1:n) - at(e)(1:n); tau(modes)] / max (abs (tau)), 1e-11);
end

## e with f (e) = 0, slopes by differences
function e = balanced (f, e)
  for k = 1:60
    for j = 1:numel (e)
      h = 1e-5 * ((1:numel (e))' == j);
      J(:,j) = (f (e + h) - f (e - h)) / 2e-5;
    end
    step = J \ f (e);
    e -= step;
    if (norm (step) <= 1e-13 * norm (e))
      break;
    end
  end
end
