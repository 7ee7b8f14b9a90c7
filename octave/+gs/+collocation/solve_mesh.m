## s = gs.collocation.solve_mesh (who, m, p, mesh, guess, o)
## The program of gs.collocation.make_program on MESH solved by Ipopt from GUESS (t from 0 to
## 1, x, v, ud, lambda, T, parameters).  S: c, z, t, x, ud, lambda, v, T, parameters, F (functions),
## g, low, high, multipliers, stopped ("", "interrupted", "timeout" at O.ends), and what
## gs.run.run_ipopt tells.

function s = solve_mesh (who, m, p, mesh, guess, o)
  c = gs.collocation.make_program (m, p, mesh);
  f = c.program;
  q = struct ("f", f ("native"), "glow", c.glow, "ghigh", c.ghigh);
  places = f ("places");
  [q.jac, q.hess] = places{:};
  [q.low, q.high] = bounds (c, p);
  q.x0 = start (c, guess, q);
  o.evaluations = Inf;
  o.seconds = max (1e-3, min (o.seconds, o.ends - time ()));
  ## of MUMPS: some ten times as fast on these programs as what it does by itself; the adaptive
  ## barrier: a third fewer iterations on the cases of the tests
  o.options = {"mumps_scaling", int32(8), "mumps_pivot_order", int32(4), "mu_strategy", "adaptive"};
  r = gs.run.run_ipopt (who, m, q, o);
  s = taken_apart (c, r);
  s.stopped = "";
  if (r.limit && time () >= o.ends)   # the clock of "guarded" interrupts Ipopt, too
    s.stopped = "timeout";
  elseif (r.interrupted)
    s.stopped = "interrupted";
  endif
  s.c = c;
  s.low = q.low;
  s.high = q.high;
  s.F = f ("functions", r.x);
  s.f = s.plain = f;
  if (c.smooth)
    plain = gs.collocation.make_program (m, rmfield (p, "singular"), mesh);
    s.plain = plain.program;
    s.J = s.plain ("f", s.z);
  endif
endfunction

function [low, high] = bounds (c, p)
  low = repmat (p.low, 1, c.K);
  high = repmat (p.high, 1, c.K);
  [low(:,1), high(:,1)] = fixed (low(:,1), high(:,1), p.x0);
  [low(:,end), high(:,end)] = fixed (low(:,end), high(:,end), p.xf);
  for one = p.ends
    low(one.number,end) = max (low(one.number,end), one.low);
    high(one.number,end) = min (high(one.number,end), one.high);
  endfor
  if (isfield (p, "held"))   # inputs of each phase
    v = c.nz - c.d.nv + (1:c.d.nv);
    low(v,:) = high(v,:) = p.held(:,c.phase);
  elseif (! any (c.stages == 1))   # nothing is asked of these at the start
    low(c.d.nx+1:end,1) = high(c.d.nx+1:end,1) = 0;
  endif
  low = [low(:); repmat(p.T(1), c.nT, 1); [p.parameters.low]'];
  high = [high(:); repmat(p.T(2), c.nT, 1); [p.parameters.high]'];
endfunction

function [low, high] = fixed (low, high, x)
  k = find (! isnan (x));
  low(k) = high(k) = x(k);
endfunction

function z = start (c, guess, q)
  T = guess.T(:)';
  at = gs.collocation.mesh_times (c, T) - c.t0;
  at = min (at / at(end), 1);
  all_of = [guess.x; guess.ud; guess.lambda; guess.v];
  Z = interp1 (guess.t(:), all_of', at(:))';
  z = [Z(:); T(:); guess.parameters(:)];
  z = max (q.low, min (q.high, z));
endfunction

function s = taken_apart (c, s)
  d = c.d;
  s.z = s.x;
  Z = reshape (s.z(1:c.K*c.nz), c.nz, c.K);
  s.x = Z(1:d.nx,:);
  s.ud = Z(d.nx+(1:d.nu),:);
  s.multipliers = s.lambda;
  s.lambda = Z(d.nx+d.nu+(1:d.nlam),:);
  s.v = Z(d.nx+d.nu+d.nlam+1:end,:);
  s.T = s.z(c.K*c.nz+(1:c.nT))';
  s.parameters = s.z(c.K*c.nz+c.nT+1:end);
  at = gs.collocation.mesh_times (c, s.T);
  s.times = at;
  s.t = (at - at(1)) / (at(end) - at(1));
endfunction
