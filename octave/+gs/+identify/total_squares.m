## f = gs.identify.total_squares (who, regression, d, sigma)
## Least squares of the motion and the parameters together (total least squares): positions D.q and
## efforts D.tau are both measured with noise, the motion is a spline (gs.identify.smooth_spline),
## and steps of Gauss and Newton from the plain estimate find both.  REGRESSION makes of a motion
## what gs.identify.regression_rows gives; SIGMA: of the efforts, [] where it follows from the data.
## F: p, covariance, noise (of each effort), noise_q (of each coordinate), w (the regression of the
## motion found), motion (the data with it), intervals (of the spline), steps, converged.
## The variance of each measured column is what is left of it over its rows less the unknowns that
## these rows determine.
## Source: Seber and Wild, Nonlinear Regression, 1989, chapter 10 (errors in variables); Foerstner
## (1979) (components of variance).

function f = total_squares (who, regression, d, sigma)
  s = gs.identify.smooth_spline (d.t, d.q);
  if (isempty (s))
    error ("%s: %d times are too few for a smooth motion through them", who, numel (d.t));
  elseif (numel (s.c) > 4000)
    error (["%s: option method: total: the motion has %d unknowns, expected at most 4000: take " ...
            "a shorter part of the data"], who, numel (s.c));
  endif
  w = regression (gs.identify.spline_derivatives (d, s.B, s.c));
  plain = gs.identify.least_squares (who, w.Y, w.b, w.names);
  p = plain.p;
  f = struct ("p", p, "c", s.c, "noise", sigma(:), "noise_q", s.noise(:), "converged", false);
  [f.intervals, f.steps] = deal (s.intervals, 0);
  while (! f.converged && f.steps < 30)
    f.steps += 1;
    a = gs.identify.motion_rows (regression, d, s.B, f);
    a.off = d.q - s.B{1} * f.c;
    f = one_step (a, s.B{1}, f, isempty (sigma));
  endwhile
  if (! f.converged)
    error ("%s: no convergence in %d steps of the motion and the parameters together", who, ...
           f.steps);
  endif
  f.motion = gs.identify.spline_derivatives (d, s.B, f.c);
  f.w = regression (f.motion);
endfunction

## the unknowns: the parameters, then the coefficients of one coordinate after the other
function f = one_step (a, B, f, free)
  n = columns (a.off);
  np = numel (f.p);
  for g = 1:n
    A{g} = [a.Y(g:n:end,:), a.D{g}];
    A{n+g} = [zeros(rows (B), np), kron((1:n) == g, B)];
    [left{g}, left{n+g}] = deal (a.rest(g:n:end), a.off(:,g));
  endfor
  if (isempty (f.noise))
    f.noise = cellfun (@(x) norm (x) / sqrt (numel (x)), left(1:n))(:) + realmin ^ 0.25;
  endif
  noise = [f.noise .* ones(n, 1); f.noise_q];
  [C, step, found] = weighted (A, left, noise);
  [share, most] = deal (1, 1e-2);
  if (f.steps > 8)   # dry friction jumps where a speed changes its sign: the middle of a cycle
    [share, most] = deal (0.5, 0.5);
  endif
  f.p += share * step(1:np);
  f.c += share * reshape (step(np+1:end), [], n);
  f.covariance = C(1:np,1:np);
  f.converged = all (abs (step(1:np)) < most * sqrt (diag (f.covariance)));
  f.noise = noise(1:n);
  if (free)
    f.noise = found(1:n);
  endif
  f.noise_q = found(n+1:end);
endfunction

## least squares of blocks of rows, each with its standard deviation; the deviations that are found
function [C, step, found] = weighted (A, left, noise)
  [M, z] = deal (0);
  for g = 1:numel (A)
    N{g} = full (A{g}' * A{g}) / noise(g) ^ 2;
    M += N{g};
    z += A{g}' * left{g} / noise(g) ^ 2;
  endfor
  scale = 1 ./ sqrt (diag (M));
  C = scale .* inv (scale .* M .* scale') .* scale';
  step = C * z;
  for g = 1:numel (A)
    took = sum (sum (C .* N{g}));
    found(g,1) = max (norm (left{g} - A{g} * step) / sqrt (max (1, rows (A{g}) - took)), ...
                      eps * norm (left{g}) + realmin ^ 0.25);
  endfor
endfunction
