## The exact linear model of the tree against differences of the inverse dynamics, where the sine of
## an angle is that of its negative (the sum of two coordinates begins with a minus).

function test_turned ()
  m = gsmbp_fixture ("turned_screws");
  [q, u, ud] = deal ([0.3; -1.1; 0.7], [1.2; -0.4; 0.9], [0.5; 2; -1.5]);
  [M, B, C] = m.lin (0, q, u, ud, []);
  ## central differences, extrapolated once: some 1e-16/1e-3 of the efforts
  inverse = @(q, u, ud) m.inv (0, q, u, ud, []);
  gsmbp_check ("turned screws: dTAU/dq", C - richardson (@(x) inverse (x, u, ud), q), 1e-9);
  gsmbp_check ("turned screws: dTAU/du", B - richardson (@(x) inverse (q, x, ud), u), 1e-9);
  gsmbp_check ("turned screws: dTAU/dud", M - richardson (@(x) inverse (q, u, x), ud), 1e-9);
end

function J = richardson (f, x)
  J = (4 * central (f, x, 1e-3) - central (f, x, 2e-3)) / 3;
end

function J = central (f, x, h)
  for k = 1:numel (x)
    step = h * ((1:numel (x))' == k);
    J(:,k) = (f (x + step) - f (x - step)) / (2 * h);
  end
end
