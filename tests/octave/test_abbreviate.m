## An abbreviated model (gsmbp_abbreviate) as it runs: its errors over the ranges it was made for, M
## and its forward dynamics, and its length.

function test_abbreviate ()
  rand ("twister", 3);
  [whole, less] = deal (gsmbp_fixture ("base_robot"), gsmbp_fixture ("base_robot_less"));
  K = 3000;
  [tau, other, split] = deal (zeros (6, K));
  [lowest, back] = deal (Inf, 0);
  for k = 1:K
    [q, u, ud] = state ();
    tau(:,k) = whole.inv (0, q, u, ud);
    other(:,k) = less.inv (0, q, u, ud);
    [M, b] = deal (less.mas (0, q), less.bia (0, q, u));
    split(:,k) = M * ud + b;
    lowest = min (lowest, min (eig (M)) / max (eig (M)));
    gone = less.fwd (0, q, u, [], split(:,k)) - ud;
    back = max (back, norm (gone) / norm (ud) * min (eig (M)) / max (eig (M)));
  end
  largest = max (abs (tau), [], 2);
  ## other states than those it was made with, where it keeps to nine tenths of the limit
  gsmbp_check ("INV over the largest effort of each row, the limit is 1 %", ...
               max (abs (other - tau), [], 2) ./ largest, 0.01);
  gsmbp_check ("M*ud + BIA over the largest effort", max (abs (split - tau), [], 2) ./ largest, ...
               0.01);
  gsmbp_check ("something was dropped", max (abs (other - tau)(:)) > 0);
  gsmbp_check (sprintf ("M is positive definite, lowest to highest eigenvalue %.1e", lowest), ...
               lowest > 0);
  gsmbp_check ("FWD is the inverse of M*ud + BIA, error over the condition of M", back, 1e-14);
  for word = {"inv", "mas", "bia", "fwd"}
    n = [operations(whole, word{1}), operations(less, word{1})];
    gsmbp_check (sprintf ("%s: %d operations instead of %d", word{1}, n(2), n(1)), n(2) < n(1));
  end
end

## a state within the ranges of base_robot_less.mac, speeds and accelerations often at their ends
function [q, u, ud] = state ()
  half = @() 2 * rand (6, 1) - 1;
  q = pi * half ();
  q(1:2) = [2.8 * (2 * rand - 1); -2 + 3 * rand];
  [u, ud] = deal (1.5 * half (), 5 * half ());
  if (rand > 0.5)
    [u, ud] = deal (1.5 * sign (u), 5 * sign (ud));
  end
end

function n = operations (m, word)
  s = m.json.subroutines(strcmpi ({m.json.subroutines.name}, [m.name "_" word]));
  n = s.operations.mul + s.operations.add + s.operations.div;
end
