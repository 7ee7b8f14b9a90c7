## Voltages and currents of motors along a planned motion as goals and demands: their derivatives
## (CMJ) against differences, designs against least squares and bisection, on a tree and a loop.

function test_optimize_drives ()
  for name = {"optimal_crank", "sensitivity_crank", "design_lifter"}
    slopes (gsmbp_fixture (name{1}));
  end
  crank = gsmbp_fixture ("optimal_crank");
  slider (crank);
  amplitude (crank);
end

## CMJ against differences of order 4 of the closure and CMX
function slopes (m)
  n = m.sizes.nu;
  planned = 1:n;
  if (m.sizes.nlam > 0)
    planned = m.actuated(:)';
  end
  one = zeros (n, m.order + 1);
  one(:,1) = m.initial(1:n);
  one(planned,:) += 0.3 + 0.1 * (1:m.order+1);
  one = closed (m, one);
  [VJ, XJ] = m.cmj (0, one);
  D = zeros (rows (VJ) + rows (XJ), 0);
  for k = 0:m.order
    for i = planned
      D(:,end+1) = slope (@(h) along (m, moved (one, i, k + 1, h)), 1e-3);
    end
  end
  for name = cellstr (m.json.sensitivity)'
    p = m.par.(name{1});
    D(:,end+1) = slope (@(h) along (gsmbp_set (m, name{1}, p + h), one), 1e-3 * p);
  end
  size_ = max (abs (D), [], 2);
  size_(size_ == 0) = 1;
  gsmbp_check ([m.name ": derivatives of inputs and states along a motion"], ...
               ([VJ; XJ] - D) ./ size_, 1e-8);
end

function d = slope (f, h)
  d = (8 * (f (h) - f (-h)) - (f (2 * h) - f (-2 * h))) / (12 * h);
end

function one = closed (m, one)
  if (m.sizes.nlam > 0)
    one = m.clo (0, one);
  end
end

function one = moved (one, i, k, h)
  one(i,k) += h;
end

function f = along (m, one)
  [v, ~, xa] = m.cmx (0, closed (m, one));
  f = [v; xa];
end

## the current is linear in the mass of the slider (here it is lifted): least squares say the best
function slider (m)
  t = linspace (0, 1.5, 41);
  plan = gsmbp_plan ("septic", [0.3 2.6], [0 1.5]);
  m = gsmbp_set (m, "g", -9.81);
  at = @(m3) gsmbp_inverse (gsmbp_set (m, "m3", m3), plan, t).x(:,end);
  [i0, i1] = deal (at (0), at (1) - at (0));
  for goal = {{"square", "motor.i"}, {"integral", "heat"}}
    r = gsmbp_optimize (m, {"m3", 2, [0 50]}, goal{1}, {}, {"inverse", plan, t});
    w = r.results.case1.w(:);
    best = -(i1' * (w .* i0)) / (i1' * (w .* i1));
    word = goal{1}{2};
    gsmbp_check ([word ": exact derivatives"], strcmp (r.derivatives, "exact"));
    gsmbp_check (sprintf ("%s: the slider of least heat, %.9g kg", word, best), ...
                 r.values.m3 - best, 1e-5);
  end
end

## the longest way in a second within 24 V
function amplitude (m)
  t = linspace (0, 1, 41);
  go = @(p) gsmbp_plan ("septic", [0.3 0.3 + p.s], [0 1]);
  most = @(s) max (abs (gsmbp_inverse (m, go (struct ("s", s)), t).v));
  r = gsmbp_optimize (m, {"s", 0.5, [0.1 2.5]}, {"end", "q1", -1}, {"peak", "motor.v", "<", 24}, ...
                      {"inverse", go, t});
  gsmbp_check ("the longest way within 24 V, exact derivatives", strcmp (r.derivatives, "exact"));
  gsmbp_check (sprintf ("... the voltage is %.9g V", most (r.values.s)), most (r.values.s) - 24, ...
               1e-5);
end
