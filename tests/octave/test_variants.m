## The variants of the DC motor side by side, through the whole chain: poles, order of their errors,
## inverse after forward.

function test_variants ()
  m = gsmbp_fixture ("variants");
  gsmbp_check ("variants: inputs in the order of the scene", ...
               isequal (m.inputs(:)', ...
                        {"full.v", "first.v", "first.v_d", "zero.v", "ideal.tau"}));
  gsmbp_check ("variants: one current, that of the full motor", ...
               isequal (m.states(9:end)(:)', {"full.i"}));

  ## slow poles in units of K^2/(R J), against (L s + R) J s + K^2 = 0
  L = 3.5e-3 * [1, 1/2, 1/4, 1/8];
  for k = 1:numel (L)
    one = gsmbp_set (m, "la", L(k));
    p = one.par;
    J = p.jw + p.jm;
    exact = max (real (roots ([L(k) * J, p.ra * J, p.km ^ 2])));
    A = one.jac (0, zeros (9, 1), zeros (5, 1));
    full(k) = abs (max (real (eig (A([1, 5, 9], [1, 5, 9]))(abs (eig (A([1, 5, 9], ...
                                      [1, 5, 9]))) > 1e-9))) / exact - 1);
    first(k) = abs (A(6, 6) / exact - 1);
    zero(k) = abs (A(7, 7) / exact - 1);
  end
  gsmbp_check ("variants: slow pole of the full motor", full, 1e-12);
  gsmbp_check (sprintf (["variants: error of qs0 is of first order in L, measured order %.3f, " ...
                         "minus " ...
                         "1"], order (zero)), order (zero) - 1, 0.05);
  gsmbp_check (sprintf (["variants: error of qs1 is of second order in L, measured order %.3f, " ...
                         "minus 2"], order (first)), order (first) - 2, 0.1);
  gsmbp_check ("variants: an ideal drive feels no speed", A(8, 8), 0);

  ## inverse after forward: the commands of a septic motion give it back
  plan = gsmbp_plan ("septic", [zeros(4, 1), [1; 1; 1; 1]], [0, 0.5]);
  t = (0:0.05:0.5)';
  r = gsmbp_inverse (m, plan, t);
  s = gsmbp_simulate (m, [r.q(1,:)'; r.u(1,:)'; 0], t, "motion", plan, "rtol", 1e-10, "atol", ...
                      1e-12);
  wrong = abs (s.x(:,1:4) - r.q);
  gsmbp_check ("variants: inverse after forward, full, rad", max (wrong(:,1)), 1e-9);
  gsmbp_check ("variants: inverse after forward, qs1, rad", max (wrong(:,2)), 1e-9);
  gsmbp_check ("variants: inverse after forward, qs0, rad", max (wrong(:,3)), 1e-9);
  gsmbp_check ("variants: inverse after forward, ideal, rad", max (wrong(:,4)), 1e-9);
end

function n = order (e)
  n = log2 (e(end-1) / e(end));
end
