## c = gs.collocation.transcribe_problem (m, p, mesh)
## An optimal motion as a sparse non-linear program: where its unknowns, equations and derivatives
## stand.  P: the problem (gs.collocation.read_problem); MESH: breaks (of each phase from 0 to 1,
## one row of intervals: [phase; begin; end]) and rule (gs.collocation.quadrature_rule).
##
## Unknowns: at each point states, accelerations, multipliers, inputs; then the durations of the
## phases, then the parameters.  Equations: at each point of a stage the residuals of the motion and
## the outputs with bounds; for each stage of each interval X - X(left) - h*A*f = 0.
## The derivatives are sums of triplets, value = k * T(phase) * G(from): G the entries of DAJ at all
## points.  Source: Betts, Practical Methods for Optimal Control and Estimation, 2010, ch. 4.

function c = transcribe_problem (m, p, mesh)
  d = m.sizes;
  s = m.json.collocation;
  c = struct ("d", d, "np", numel (p.parameters), "mesh", mesh, "t0", p.t0);
  c.parameters = {p.parameters.name};
  c.nr = s.residuals;
  c.nf = c.nr + s.rates + s.outputs;
  c.nz = d.nx + d.nu + d.nlam + d.nv;
  c = points_of (c, mesh);
  c.nT = max (mesh.breaks(1,:));
  c.n = c.K * c.nz + c.nT + c.np;
  c = local_places (c, s);
  c = equations (c, p);
  c = jacobian (c);
  c = second_derivatives (c);
  c = integrand (c, p);
endfunction

## the points: times, of which phase, whether a stage stands there; of each interval the left one
## and those of the stages
function c = points_of (c, mesh)
  own = numel (mesh.rule.own);
  n = columns (mesh.breaks);
  c.K = own * n + 1;
  c.left = own * (0:n-1) + 1;
  c.stage = c.left + [(own+1-numel (mesh.rule.c)):own]';   # a column for each interval
  c.phase = [1, repelem(mesh.breaks(1,:), own)];
  c.h = diff (mesh.breaks(2:3,:));
  at = mesh.breaks(2,:) + mesh.rule.c(mesh.rule.own)' .* c.h;
  c.tau = [0, at(:)'];
  c.stages = unique (c.stage(:))';
endfunction

## the unknowns of the functions at all points: column of the program and factor of the time
function c = local_places (c, s)
  d = c.d;
  base = (0:c.K-1) * c.nz;
  c.at = @(l, i) base(i) + l;
  T = c.K * c.nz + c.phase;
  c.columns = [T; (1:c.nz)' + base; c.K * c.nz + c.nT + repmat((1:c.np)', 1, c.K)];
  c.J = reshape (s.jacobian, [], 2);   # [] where a scene has none
  c.H = reshape (s.hessian, [], 2);
  ## rates of the states: of coordinates and devices functions, of speeds the accelerations
  c.rate = [c.nr + (1:d.nq), zeros(1, d.nu), c.nr + d.nq + (1:d.nx-d.nq-d.nu)];
  c.speed = d.nq + (1:d.nu);
  c.output = c.nf - s.outputs;
endfunction

## numbers of the equations: residuals, outputs with bounds, stages
function c = equations (c, p)
  own = numel (c.mesh.rule.own);
  k = numel (c.stages);
  c.residual = reshape (1:c.nr*k, c.nr, k);
  c.bounded = c.output + [p.outputs.number];
  nb = numel (c.bounded);
  c.path = c.nr * k + reshape (1:nb*k, nb, k);
  n = columns (c.left);
  c.defect = c.nr * k + nb * k + reshape (1:c.d.nx*own*n, c.d.nx, own, n);
  c.m = c.nr * k + nb * k + c.d.nx * own * n;
  c.glow = [zeros(c.nr*k, 1); repmat([p.outputs.low]', k, 1); zeros(c.d.nx*own*n, 1)];
  c.ghigh = [zeros(c.nr*k, 1); repmat([p.outputs.high]', k, 1); zeros(c.d.nx*own*n, 1)];
  c.goal = zeros (c.nf, 1);
  c.goal(c.output+[p.goal.number]) = [p.goal.weight];
  c.goal_time = p.goal_time;
  c.final_x = p.final.x;
  c.final_f = [zeros(c.output, 1); p.final.y];
  c.weights = zeros (c.nT, c.K);   # of the integral, without the durations
  for k = 1:n
    c.weights(c.mesh.breaks(1,k),c.stage(:,k)) += c.h(k) * c.mesh.rule.b;
  endfor
endfunction

## Triplets [row, column, k, from] of the derivatives of the equations: fixed ones; plain ones,
## k*G(from); timed ones, k*T(of)*G(from), from 0: k*T(of).
function c = jacobian (c)
  own = c.mesh.rule.own;
  nx = c.d.nx;
  count = numel (c.stages);
  f = [1:c.nr, c.bounded];
  c.plain = entries (c, f, [c.residual; c.path], c.stages, ones (1, count));
  c.fixed = zeros (0, 4);
  c.timed = zeros (0, 4);
  c.of = zeros (0, 1);
  for s = 1:numel (own)
    row = reshape (c.defect(:,s,:), nx, []);
    c.fixed = [c.fixed; states(c, row, c.stage(own(s),:), 1); states(c, row, c.left, -1)];
    for j = 1:columns (c.mesh.rule.A)
      q = c.stage(j,:);
      a = -c.h * c.mesh.rule.A(s,j);
      l = find (c.rate);
      more = [entries(c, c.rate(l), row(l,:), q, a)
              accelerations(c, row(c.speed,:), q, a)];
      c.timed = [c.timed; more];
      ## the duration belongs to the interval, whose phase its last point has
      c.of = [c.of; c.mesh.breaks(1,interval_of(c, more(:,1)))(:)];
    endfor
  endfor
  c = durations (c);
endfunction

## the interval of a defect's equation
function k = interval_of (c, row)
  k = ceil ((row - c.defect(1) + 1) / (c.d.nx * numel (c.mesh.rule.own)));
endfunction

## the entries of the functions F at the points Q as triplets of the equations ROW (of a function,
## of a point), times K (of a point); what is by time by the duration
function l = entries (c, f, row, q, k)
  number = zeros (1, c.nf);
  number(f) = 1:numel (f);
  e = find (number(c.J(:,1)));
  n = numel (q);
  factor = repmat (k, numel (e), 1);
  by_time = c.J(e,2) == 1;
  factor(by_time,:) .*= repmat (c.tau(q), sum (by_time), 1);
  rows_ = row(number(c.J(e,1)),:);
  columns_ = c.columns(c.J(e,2),q);
  from = (q - 1) * rows (c.J) + e(:);
  l = [rows_(:), columns_(:), factor(:), from(:)];
endfunction

## the states at the points Q in the equations ROW
function l = states (c, row, q, k)
  column = c.at((1:c.d.nx)', q);
  l = [row(:), column(:), k * ones(numel (row), 1), zeros(numel (row), 1)];
endfunction

## the accelerations at the points Q as rates of the speeds
function l = accelerations (c, row, q, k)
  column = c.at(c.d.nx + (1:c.d.nu)', q);
  k = repmat (k, c.d.nu, 1);
  l = [row(:), column(:), k(:), zeros(numel (row), 1)];
endfunction

## what stands in the columns of the durations: sums of rates, T without
function c = durations (c)
  own = numel (c.mesh.rule.own);
  n = columns (c.left);
  [s, j, k] = ndgrid (1:own, 1:columns (c.mesh.rule.A), 1:n);
  a = -c.h(k(:))(:) .* c.mesh.rule.A(sub2ind (size (c.mesh.rule.A), s(:), j(:)));
  q = c.stage(sub2ind (size (c.stage), j(:), k(:)));
  c.sums = sparse ((k(:) - 1) * own + s(:), q(:), a, own * n, c.K);
  phase = repelem (c.mesh.breaks(1,:), own * c.d.nx)(:);
  c.by_duration = [c.defect(:), c.K*c.nz + phase];
  c.of_defect = repelem (c.mesh.breaks(1,:), own);
endfunction

## Triplets of the second derivatives, lower triangle: k*H(from) with the weights of the functions;
## then those by a duration and what a rate or an output depends on: k*G(from)*(weight of it without
## the duration); the same of the accelerations: weight.
function c = second_derivatives (c)
  nH = rows (c.H);
  q = 1:c.K;
  factor = c.tau .^ (double (c.H(:,1) == 1) + double (c.H(:,2) == 1));
  a = c.columns(c.H(:,1),q);
  b = c.columns(c.H(:,2),q);
  from = (q - 1) * nH + (1:nH)';
  c.curved = [max(a(:), b(:)), min(a(:), b(:)), factor(:), from(:)];
  c.crossed = zeros (0, 5);
  c.crossed_speeds = zeros (0, 3);
  for phase = 1:c.nT
    q = unique (c.stage(:,c.mesh.breaks(1,:) == phase))(:)';
    c.crossed = [c.crossed; crossed(c, phase, q)];
    b = c.at(c.d.nx + (1:c.d.nu)', q);
    at = (phase - 1) * c.d.nu * c.K + (q - 1) * c.d.nu + (1:c.d.nu)';
    c.crossed_speeds = [c.crossed_speeds
                        (c.K*c.nz + phase) * ones(numel (b), 1), b(:), at(:)];
  endfor
endfunction

## a duration and the functions at the points Q of its phase
function l = crossed (c, phase, q)
  nJ = rows (c.J);
  e = find (c.J(:,1) > c.nr)(:);
  a = repmat (c.K * c.nz + phase, numel (e), numel (q));
  b = c.columns(c.J(e,2),q);
  factor = ones (size (a));
  by_time = c.J(e,2) == 1;
  factor(by_time,:) = 2 * repmat (c.tau(q), sum (by_time), 1);
  from = (q - 1) * nJ + e;
  weight = ((phase - 1) * c.K + q - 1) * c.nf + c.J(e,1);
  l = [max(a(:), b(:)), min(a(:), b(:)), factor(:), from(:), weight(:)];
endfunction

## What the goal integrates of the unknowns of a point: own_linear (a column for each point),
## own_products ([a, b, weight], b not behind a), and its second derivatives: own_curved [row,
## column, k, point], times the weight of the point; own_crossed [row, column, unknown, point,
## phase], its derivative by the unknown times the weight without the duration.
function c = integrand (c, p)
  c.own_linear = repmat (p.own.linear, 1, c.K);
  c.own_products = p.own.products;
  q = find (any (c.weights, 1));
  c.own_curved = c.own_crossed = [];
  for one = c.own_products'
    k = one(3) * (1 + (one(1) == one(2))) * ones (numel (q), 1);
    c.own_curved = [c.own_curved; c.at(one(1), q)', c.at(one(2), q)', k, q'];
  endfor
  used = unique ([find(any (c.own_linear, 2)); c.own_products(:,1:2)(:)])(:);
  for phase = 1:c.nT
    q = find (c.weights(phase,:));
    [l, point] = ndgrid (used, q);
    T = (c.K * c.nz + phase) * ones (numel (l), 1);
    c.own_crossed = [c.own_crossed
                     T, c.at(l(:)', point(:)')', l(:), point(:), phase * ones(numel (l), 1)];
  endfor
  c.own_curved = reshape (c.own_curved, [], 4);
  c.own_crossed = reshape (c.own_crossed, [], 5);
  c.rough = zeros (0, 3);   # what else the goal has: half of z' P z, the lower triangle of P
  if (isfield (p, "singular"))
    c.rough = gs.collocation.input_roughness (c, p.singular);
  endif
endfunction
