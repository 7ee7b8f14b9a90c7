## c = gs.collocation.make_program (m, p, mesh)
## The non-linear program of a problem P (gs.collocation.read_problem) on MESH: breaks (of each
## phase from 0 to 1, one row of intervals: [phase; begin; end]) and rule
## (gs.collocation.quadrature_rule), by host/collocation/program.h: where its unknowns and equations
## are, and program (what, z, factor, lambda): its goal "f", "grad", the equations "g", the entries
## of "jac" and "hess"; "places" of these, "functions" of DAE at all points; "native" is what
## gs.run.run_ipopt takes instead; "time" what all of them take [s].

function c = make_program (m, p, mesh)
  s = m.json.collocation;
  c = struct ("d", m.sizes, "mesh", mesh, "t0", p.t0);
  c.parameters = {p.parameters.name};
  c.nr = s.residuals;
  c.nz = c.d.nx + c.d.nu + c.d.nlam + c.d.nv;
  c.output = c.nr + s.rates;
  c.J = reshape (s.jacobian, [], 2);   # [] where a scene has none
  c.rate = [c.nr + (1:c.d.nq), zeros(1, c.d.nu), c.nr + c.d.nq + (1:c.d.nx-c.d.nq-c.d.nu)];
  c.speed = c.d.nq + (1:c.d.nu);
  c = equations (points_of (c, mesh), p);
  c.smooth = isfield (p, "singular");
  method = strcmp (mesh.rule.name, "lobatto");
  [number, J, H] = m.module ("program", m.cst, gs.model.parameter_values (m), p, method, ...
                             mesh.breaks);
  c.program = @(varargin) answer (m, number, {J, H}, c.output + s.outputs, varargin{:});
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
  base = (0:c.K-1) * c.nz;
  c.at = @(l, i) base(i) + l;
  c.nT = max (mesh.breaks(1,:));
  c.n = c.K * c.nz + c.nT + numel (c.parameters);
  c.weights = zeros (c.nT, c.K);   # of the integral, without the durations
  for k = 1:n
    c.weights(mesh.breaks(1,k),c.stage(:,k)) += c.h(k) * mesh.rule.b;
  endfor
  c.sums = sparse (own * n, c.K);   # of the rates, in each defect
  for k = 1:n
    c.sums(own*(k-1)+(1:own),c.stage(:,k)) = -c.h(k) * mesh.rule.A;
  endfor
endfunction

## numbers of the equations: residuals, outputs with bounds, stages
function c = equations (c, p)
  own = numel (c.mesh.rule.own);
  k = numel (c.stages);
  c.bounded = c.output + [p.outputs.number];
  nb = numel (c.bounded);
  n = columns (c.left);
  c.residual = reshape (1:c.nr*k, c.nr, k);
  c.path = c.nr * k + reshape (1:nb*k, nb, k);
  c.defect = (c.nr + nb) * k + reshape (1:c.d.nx*own*n, c.d.nx, own, n);
  c.m = (c.nr + nb) * k + c.d.nx * own * n;
  c.glow = [zeros(c.nr*k, 1); repmat([p.outputs.low]', k, 1); zeros(c.d.nx*own*n, 1)];
  c.ghigh = [zeros(c.nr*k, 1); repmat([p.outputs.high]', k, 1); zeros(c.d.nx*own*n, 1)];
endfunction

function v = answer (m, number, places, nf, what, z = [], factor = 1, lambda = [])
  switch (what)
    case "places"
      v = places;
    case "native"
      v = m.module ("program at", number);
    case "time"   # of all parts at a new point, called from compiled code [s]
      v = m.module ("program time", number, 200, z, lambda);
    case "functions"
      v = reshape (m.module ("program part", number, 5, z, 1, []), nf, []);
    otherwise
      part = find (strcmp (what, {"f", "grad", "g", "jac", "hess"})) - 1;
      v = m.module ("program part", number, part, z, factor, lambda);
  endswitch
endfunction
