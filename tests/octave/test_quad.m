## Rounding error: the same Fortran built in double and in quad precision, at random states; error
## relative to the largest entry of each result. Derivatives that a run in quad precision carries.

function test_quad ()
  rand ("twister", 3);
  for name = {"case_01a", "case_02a_motor", "case_03a"}
    m = gsmbp_fixture (name{1});
    exact = gsmbp_fixture (name{1}, "precision", "quad");
    gsmbp_check ([name{1} " static routines against quad precision"], statics (m, exact), 1e-13);
    ## forward dynamics: rounding times the condition of M or of the loop
    gsmbp_check ([name{1} " right-hand side and Jacobians against quad precision"], ...
                 dynamics (m, exact), 1e-12);
  end
  thrown (gsmbp_fixture ("sensitivity_ball", "precision", "quad"));
end

## Derivatives that a run in quad precision carries through an impact, against the closed form: a
## ball from rest at 1 m above LO at 0.9 s. What remains is the rounding of what comes back, double.
function thrown (m)
  [g, e, t] = deal (9.81, 0.8, 0.9);
  t1 = sqrt (2 / g);   # the impact
  s = t - t1;
  by_t1 = e * g * s - e * g * t1 + g * s;
  r = gsmbp_simulate (m, [1.1; 0; 0; 0], [0, t], "sensitivity", {"g", "lo", "e"}, "rtol", 1e-22);
  found = [r.dx.g(2,1), r.dx.lo(2,1), r.dx.e(2,1), r.events.dt.g(1)];
  wanted = [e * t1 * s - s^2 / 2 - by_t1 * t1 / (2 * g), 1 - by_t1 / (g * t1), g * t1 * s, ...
            -t1 / (2 * g)];
  gsmbp_check ("derivatives through an impact in quad precision", compare (found, wanted), 2e-15);
end

function e = compare (a, b)
  e = max (abs (a(:) - b(:))) / max (1, max (abs (b(:))));
end

function worst = statics (m, exact)
  d = m.sizes;
  worst = 0;
  for trial = 1:20
    [q, u, ud, v] = deal (2 * rand (d.nq, 1) - 1, 4 * rand (d.nu, 1) - 2, ...
                          4 * rand (d.nu, 1) - 2, 2 * rand (d.nv, 1) - 1);
    [M, B, C] = m.lin (0, q, u, ud, v);
    [Mq, Bq, Cq] = exact.lin (0, q, u, ud, v);
    worst = max ([worst, compare(m.mas (0, q), exact.mas (0, q)), compare(m.bia (0, q, u, v), ...
        exact.bia (0, q, u, v)), ...
                  compare(m.inv (0, q, u, ud, v), exact.inv (0, q, u, ud, v)), compare(B, ...
                      Bq), compare(C, Cq)]);
  end
end

function worst = dynamics (m, exact)
  d = m.sizes;
  worst = 0;
  for trial = 1:20
    x = m.initial + 0.1 * (2 * rand (d.nx, 1) - 1);
    if (d.nlam > 0)
      x = m.prj (0, x);
    end
    v = 2 * rand (d.nv, 1) - 1;
    [A, B] = m.jac (0, x, v);
    [Aq, Bq] = exact.jac (0, x, v);
    worst = max ([worst, compare(m.rhs (0, x, v), exact.rhs (0, x, v)), compare(A, Aq), ...
                  compare(B, Bq)]);
  end
end
