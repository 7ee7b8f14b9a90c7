## Base parameters and regressor (REG): Y*p + r against INV, the rank of Y by singular values,
## motion of mass that the joints cannot feel.

function test_base ()
  rand ("twister", 5);
  for name = {"base_robot", "base_tree"}
    m = gsmbp_fixture (name{1});
    [Y, e] = rows_of (m, 60);
    n = numel (m.json.base_parameters);
    ## sums of some hundred terms that cancel at most tenfold
    gsmbp_check (sprintf ("%s: Y*p + r is INV", name{1}), e, 1e-13);
    gsmbp_check (sprintf ("%s: columns of Y have a common size", name{1}), columns (Y) == n);
    s = svd (Y ./ norm (Y, "columns"));
    gsmbp_check (sprintf ("%s: %d base parameters, singular values from %.1e to %.1e", name{1}, ...
                          n, s(1), s(end)), s(end) > 1e-6 * s(1));
    p = arrayfun (@(b) b.value, m.json.base_parameters(:));
    [~, q] = first_state (m);
    gsmbp_check (sprintf ("%s: values in the JSON", name{1}), (p - q) ./ max (abs (q), 1e-3), ...
                 1e-14);
  end
  ## 7 (n - 1) + 1 parameters of a chain of n revolute joints, the first vertical (Gautier and
  ## Khalil 1990)
  gsmbp_check ("six revolute joints, the first vertical: 36", ...
               numel (gsmbp_fixture ("base_robot").json.base_parameters) == 36);
  unfelt (gsmbp_fixture ("base_robot"));
end

## 60 states: the rows of their regressors, largest relative error of Y*p + r
function [A, e] = rows_of (m, K)
  [A, e] = deal ([], 0);
  for k = 1:K
    [q, u, ud, v] = state (m);
    [Y, p, r] = m.reg (0.3, q, u, ud, v);
    tau = m.inv (0.3, q, u, ud, v);
    e = max (e, norm (Y * p + r - tau) / norm (abs (Y) * abs (p) + abs (r)));
    A = [A; Y];
  end
end

function [q, u, ud, v] = state (m)
  d = m.sizes;
  q = 3 * (2 * rand (d.nq, 1) - 1);
  for i = 1:rows (m.orientation)
    k = m.orientation(i,:);
    q(k) /= norm (q(k));
  end
  u = 2 * (2 * rand (d.nu, 1) - 1);
  ud = 5 * (2 * rand (d.nu, 1) - 1);
  v = rand (d.nv, 1);
end

function [Y, p] = first_state (m)
  [q, u, ud, v] = state (m);
  [Y, p] = m.reg (0, q, u, ud, v);
end

## mass of link 1 on its axis, which stands still; mass on the third axis, moved from one side of
## the joint to the other
function unfelt (m)
  [q, u, ud] = state (m);
  tau = m.inv (0, q, u, ud);
  other = gsmbp_set (m, "m1", 40);
  gsmbp_check ("a mass on an axis that stands still is not felt", other.inv (0, q, u, ud) == tau);
  other = gsmbp_set (m, struct ("w2", 0.1, "w3", 0.6));
  ## the constants round anew
  gsmbp_check ("nor is mass moved through the axis that two links share", ...
               (other.inv (0, q, u, ud) - tau) / norm (tau), 1e-14);
end
