## g = gs.collocation.first_guess (who, m, p, given)
## Where gsmbp_collocate begins: t (from 0 to 1), x, v, ud, lambda (a column for each), T,
## parameters. Without a guess GIVEN states lie on a line between the ends, in a closed chain moved
## onto the loops; inputs are 0 or the nearest value; accelerations are what these lines of the
## speeds have: those of the machine there belong to another motion, from which Ipopt needs up to
## twice as many iterations. With one, accelerations and multipliers follow from it.

function g = first_guess (who, m, p, given)
  d = m.sizes;
  g.T = min (max (1, p.T(1)), p.T(2));
  g.parameters = cellfun (@(name) m.par.(name), {p.parameters.name})(:);
  g.parameters = max ([p.parameters.low]', min ([p.parameters.high]', g.parameters));
  if (isempty (given))
    x0 = either (p.x0, p.followed, m.initial);
    xf = either (p.followed, p.x0, m.initial);
    g.t = linspace (0, 1, 21);
    g.x = x0 + (xf - x0) * g.t;
    g.v = zeros (d.nv, numel (g.t));
  else
    g = taken (who, m, p, given, g);
  endif
  v = d.nx + d.nu + d.nlam;
  g.v = max (p.low(v+1:end), min (p.high(v+1:end), g.v));
  g = followed (m, g, isempty (given));
endfunction

function x = either (x, y, z)
  x(isnan (x)) = y(isnan (x));
  x(isnan (x)) = z(isnan (x));
endfunction

function g = taken (who, m, p, given, g)
  for name = {"t", "x", "v"}
    if (! (isstruct (given) && isscalar (given) && isfield (given, name{1})))
      error ("%s: option guess: expected a struct with t, x, v, found %s", who, ...
             gs.text.shown_value (given));
    endif
  endfor
  t = given.t(:)';
  n = numel (t);
  sizes = isequal (size (given.x), [n m.sizes.nx]) && isequal (size (given.v), [n m.sizes.nv]);
  fine = n > 1 && all (diff (t) >= 0) && t(end) > t(1) && sizes ...
         && all (isfinite ([given.x(:); given.v(:)]));
  if (! fine)
    error (["%s: option guess: expected rising times, a row of %d states and of %d inputs for " ...
            "each, found %s, %s and %s"], who, m.sizes.nx, m.sizes.nv, ...
                gs.text.shown_value (given.t), ...
           gs.text.shown_value (given.x), gs.text.shown_value (given.v));
  endif
  g.T = min (max (t(end) - t(1), p.T(1)), p.T(2));
  last = [diff(t) > 0, true];   # of equal times
  g.t = (t(last) - t(1)) / (t(end) - t(1));
  g.x = given.x(last,:)';
  g.v = given.v(last,:)';
endfunction

## positions that the loops allow, one after the other; accelerations and multipliers
function g = followed (m, g, straight)
  d = m.sizes;
  n = numel (g.t);
  g.ud = zeros (d.nu, n);
  g.lambda = zeros (d.nlam, n);
  before = [];
  for k = 1:n
    x = g.x(:,k);
    if (straight && d.nlam > 0)
      dependent = setdiff (1:d.nq, m.actuated);
      if (! isempty (before))
        x(dependent) = before(dependent);
      endif
      try
        [y, ~, info] = m.prj (g.t(k) * g.T, x);
        if (info == 0 && all (isfinite (y)))
          x = y;
        endif
      end_try_catch
      before = g.x(:,k) = x;
    endif
    if (d.nlam > 0)
      [ud, lambda, info] = m.acc (g.t(k) * g.T, x, g.v(:,k));
      lambda(! isfinite (lambda)) = 0;
      g.lambda(:,k) = lambda;
    else
      [xd, info] = m.rhs (g.t(k) * g.T, x, g.v(:,k));
      ud = xd(d.nq+(1:d.nu));
    endif
    ud(! isfinite (ud)) = 0;
    g.ud(:,k) = ud;
  endfor
  if (straight)
    u = g.x(d.nq+(1:d.nu),[1 end]);
    g.ud = repmat (diff (u, 1, 2) / g.T, 1, n);
  endif
endfunction
