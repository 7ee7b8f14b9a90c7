## gsmbp_adjoint against closed forms: a damped oscillation, its angle and its derivatives by
## stiffness, damping, inertia and both start values, as near as the tolerance asks.

function test_adjoint ()
  m = gsmbp_set (gsmbp_fixture ("case_d1a"), "g", 0, "k", 7);   # a linear oscillator without weight
  J = m.par.I + m.par.m * m.par.l ^ 2;
  [x0, T] = deal ([1; -0.5], 3);
  goal = @(r) deal (r.x(end,1), [zeros(rows (r.x) - 1, 2); 1 0]);
  names = {"k", "d", "I", "theta", "theta_d"};
  at = [7, m.par.d, J, x0'];
  wanted = arrayfun (@(p) slope (p, at, T), 1:5);
  worst = zeros (1, 5);
  for rtol = 10 .^ [-4, -6, -8, -10]
    a = gsmbp_adjoint (m, x0, [0, 1, T], goal, "rtol", rtol);
    gsmbp_check (sprintf ("angle over the tolerance %g", rtol), ...
                 (a.J - angle (num2cell (at){:}, T)) / rtol, 2);
    found = [a.dJ.k, a.dJ.d, a.dJ.I, a.dx0];
    worst = max (worst, abs (at .* (found - wanted)) / rtol);
  endfor
  for k = 1:5
    gsmbp_check (["its change with that of " names{k} " by its share, over the tolerance"], ...
                 worst(k), 20);
  endfor
endfunction

## J x'' + d x' + k x = 0
function x = angle (k, d, J, x0, v0, T)
  [s, w] = deal (d / (2 * J), sqrt (k / J - (d / (2 * J)) ^ 2));
  x = exp (-s * T) * (x0 * cos (w * T) + (v0 + s * x0) / w * sin (w * T));
endfunction

## its derivative by argument number P: an imaginary step, exact to rounding
function y = slope (p, at, T)
  at(p) += 1e-100i;
  y = imag (angle (num2cell (at){:}, T)) / 1e-100;
endfunction
