## t = gs.control.step_responses (who, c, mc, run)
## Responses in time of the controller C on its plant, and RUN, of the model MC with it: linear,
## machine (times), y and u (names, units, linear, machine), stepped (u is held between samples).

function t = step_responses (who, c, mc, run)
  t = struct ("linear", [], "machine", [], "stepped", c.period > 0);
  t.y = struct ("names", {c.measured(:)'}, "units", {{}}, "machine", [], "linear", []);
  t.u = struct ("names", {c.driven(:)'}, "units", {{}}, "machine", [], "linear", []);
  if (isempty (mc))
    t = steps (c, t);
    return;
  endif
  gs.given.check_model (who, mc);
  reads = gs.given.places_of (c.measured, mc.outputs);
  drives = gs.given.places_of (c.driven, mc.inputs);
  refs = gs.given.places_of (strcat (c.name, ".", c.references), mc.inputs);
  own = gs.given.places_of (c.plant.stname, mc.states);
  if (! (isstruct (run) && all (isfield (run, {"t", "x", "y", "v"}))) || ! all (reads) || ...
      ! all (drives) || ! all (refs))
    error (["%s: expected a run of gsmbp_simulate of a model that was built with the " ...
            "controller %s, found %s"], who, c.name, gs.text.shown_value (run));
  endif
  t.machine = run.t;
  t.y.machine = run.y(:,reads);
  t.u.machine = run.v(:,drives);
  t.y.units = mc.units.outputs(reads)(:)';
  t.u.units = mc.units.inputs(drives)(:)';
  x = zeros (rows (c.plant.a), 1);
  x(own > 0) = run.x(1,own(own > 0))' - c.x0(1:sum (own > 0));
  n = floor ((run.t(end) - run.t(1)) / c.period) + 1;
  r = zeros (numel (refs), n);
  if (isfield (run, "samples") && rows (run.samples.v) > 0)
    at = run.t(1) + (0:n-1) * c.period;   # instants at which outputs arrive are rows, too
    at = at(at <= run.samples.t(end) + 1e-6 * c.period);
    k = max (1, lookup (run.samples.t, at + 1e-6 * c.period));
    r = run.samples.v(k,refs)' - c.r0;
  endif
  t = sampled (c, t, x, r, run.t(1));
endfunction

## the difference equation; limits and converters are not in it
function t = sampled (c, t, x, r, t0)
  [F, H, S] = deal (c.plant.a, c.plant.b, c.plant.c);
  z = zeros (rows (c.A), 1);
  n = columns (r);
  y = zeros (n, rows (S));
  u = zeros (n, columns (H));
  for k = 1:n
    e = [S * x; r(:,k)];
    y(k,:) = (S * x)' + c.y0';
    v = c.C * z + c.D * e;
    u(k,:) = v' + c.u0';
    z = c.A * z + c.B * e;
    x = F * x + H * v;
  endfor
  t.linear = t0 + (0:n-1)' * c.period;
  t.y.linear = y;
  t.u.linear = u;
endfunction

## steps of the references, or of a disturbance at the first input
function t = steps (c, t)
  poles = eig (gs.control.closed_loop (c));
  if (c.period > 0)
    rate = -log (max (abs (poles))) / c.period;
    n = ceil (min (6 / rate / c.period, 5000));
    r = ones (numel (c.references), n);
    x = zeros (rows (c.plant.a), 1);
    if (isempty (c.references))
      x += c.plant.b(:,1);
    endif
    t = sampled (c, t, x, r, 0);
    return;
  endif
  if (c.delay > 0)
    t = late (c, t);
    return;
  endif
  [A, B, C] = gs.control.closed_loop (c);
  nr = numel (c.references);
  b = sum (B(:,1:nr), 2);
  if (nr == 0)
    b = B(:,1);
  endif
  rate = -max (real (poles));
  t.linear = linspace (0, 6 / rate, 600)';
  N = rows (A);
  E = expm ([A, b; zeros(1, N + 1)] * t.linear(2));
  x = [zeros(N, 1); 1];
  y = zeros (600, rows (C));
  D = [zeros(numel (c.measured), 1); sum(c.D(:,rows (c.plant.c) + 1:end), 2)];
  for k = 1:600
    y(k,:) = (C * x(1:N) + D)';
    x = E * x;
  endfor
  t.y.linear = y(:,1:numel (c.measured)) + c.y0';
  t.u.linear = y(:,numel (c.measured) + 1:end) + c.u0';
endfunction

## a continuous loop with dead time: inputs that come late, taken as straight lines between short
## steps
function t = late (c, t)
  [F, H, S] = deal (c.plant.a, c.plant.b, c.plant.c);
  w = gs.control.frequency_grid (struct ("A", F, "h", 0), c.delay, []);
  margins = gs.control.loop_margins (gs.control.loop_response (c, 1), w);
  crossover = margins.crossover;
  n = 40;
  h = c.delay / n;
  N = min (ceil (15 / min (crossover, 1 / c.delay) / h), 20000);
  nx = rows (F);
  nz = rows (c.A);
  r = ones (numel (c.references), 1);
  [E, I1, I2] = straight (F, H, h);
  [Ez, J1, J2] = straight (c.A, c.B, h);
  x = zeros (nx, 1);
  if (isempty (r))
    x = H(:,1);
  endif
  z = zeros (nz, 1);
  v = zeros (columns (H), N + n + 1);   # v(:,k+n+1): at the time k h
  y = zeros (N, rows (S));
  e = [S * x; r];
  for k = 1:N
    y(k,:) = (S * x)';
    v(:,k+n) = c.C * z + c.D * e;
    x = E * x + I1 * v(:,k) + I2 * v(:,k+1);
    f = [S * x; r];
    z = Ez * z + J1 * e + J2 * f;
    e = f;
  endfor
  t.linear = (0:N-1)' * h;
  t.y.linear = y + c.y0';
  t.u.linear = v(:,n + (1:N))' + c.u0';
endfunction

## a step of the time H of an input that is a straight line from its first to its second value
function [E, I1, I2] = straight (A, B, h)
  [n, m] = size (B);
  X = expm ([A, B, zeros(n, m); zeros(m, n + m), eye(m) / h; zeros(m, n + 2 * m)] * h);
  E = X(1:n,1:n);
  I2 = X(1:n,n + m + (1:m));
  I1 = X(1:n,n + (1:m)) - I2;
endfunction
