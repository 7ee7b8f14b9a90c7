## The Jacobian of the state equations of closed chains: JAC, all columns in one loop, against JAD,
## its general form, which it calls where a pivot is small or the loops are solved in another way.
## Against differences of RHS: test_invariants.

function test_jacobian ()
  rand ("twister", 11);
  for name = {"batch_bars", "driven_fourbar", "sensitivity_crank"}
    m = gsmbp_fixture (name{1});
    worst = 0;
    for k = 1:20
      x = m.initial + 0.2 * (2 * rand (m.sizes.nx, 1) - 1);
      v = 2 * rand (m.sizes.nv, 1) - 1;
      worst = max (worst, apart (m, x, v));
    end
    gsmbp_check ([name{1} ": JAC is JAD"], worst, 1e-10);
  end
  for way = 2:4
    m = gsmbp_fixture ("batch_bars", "parameters", struct ("loop_method", way));
    gsmbp_check (sprintf ("loop_method %d is that of JAD", way), apart (m, m.initial, [0; 0]), 0);
  end
  m = gsmbp_set (gsmbp_fixture ("batch_bars"), "lc", 0.25, "ld", 0.7);
  flat = [0; 0; 0; 1; -1; 1; zeros(m.sizes.nx - 6, 1)];
  gsmbp_check ("a flat parallelogram, whose constraints have lost rank", ...
               apart (m, flat, [0; 0]), 0);
  [A, ~, ~, ~, info] = m.jac (0, flat, [0; 0]);
  gsmbp_check ("... has a Jacobian", all (isfinite (A(:))) && info == 0);
end

## the largest difference over the largest entry
function d = apart (m, x, v)
  [A, B, C, D] = m.jac (0, x, v);
  [A1, B1, C1, D1] = m.jad (0, x, v);
  d = max ([difference(A, A1), difference(B, B1), difference(C, C1), difference(D, D1)]);
end

function d = difference (A, B)
  d = 0;
  if (! isempty (A))
    d = max (abs (A(:) - B(:))) / max (1, max (abs (B(:))));
  end
end
