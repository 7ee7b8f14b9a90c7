## f = gsmbp__transcribed (m, c)
## The program of gsmbp__transcription C as Ipopt asks for it (gsmbp__ipopt): f (what, z, factor,
## lambda) is its goal "f", "grad", the equations "g", the triplets of "jac" and "hess"; "places"
## tells where these stand, "functions" those of DAE at all points.  What one point needs is
## evaluated once.

function f = gsmbp__transcribed (m, c)
  persistent count = 0;
  c.number = count += 1;   # tells it from another program at the same point
  f = @(varargin) answer (m, c, varargin{:});
endfunction

function v = answer (m, c, what, z = [], factor = 1, lambda = [])
  if (strcmp (what, "places"))
    v = {[c.fixed(:,1:2); c.plain(:,1:2); c.timed(:,1:2); c.by_duration]
         [c.curved(:,1:2); c.crossed(:,1:2); c.crossed_speeds(:,1:2)]};
    return;
  endif
  e = evaluated (z, m, c);
  switch (what)
    case "f"
      v = c.goal_time * sum (e.T) + e.T * c.weights * (c.goal' * e.F)';
    case "grad"
      v = gradient (c, e);
    case "g"
      v = equations (c, e);
    case "jac"
      h = e.T(c.of)(:);
      k = c.timed(:,4);
      g = ones (size (k));
      g(k > 0) = e.G(k(k > 0));
      v = [c.fixed(:,3); c.plain(:,3) .* e.G(c.plain(:,4))(:); h .* c.timed(:,3) .* g
           sums(c, e)(:)];
    case "functions"
      v = e.F;
    case "hess"
      v = hessian (m, c, e, factor, lambda);
  endswitch
endfunction

## the point taken apart, with the functions and their derivatives
function e = evaluated (z, m, c)
  persistent last = [];
  persistent kept = [];
  if (isequal ([c.number; z], last))
    e = kept;
    return;
  endif
  d = c.d;
  e.Z = reshape (z(1:c.K*c.nz), c.nz, c.K);
  e.T = z(c.K*c.nz+(1:c.nT))';
  e.p = z(c.K*c.nz+c.nT+1:end);
  e.m = gsmbp__collocation_model (m, c, e.p);
  e.points = {c.K, gsmbp__collocation_times(c, e.T), e.Z(1:d.nx,:), e.Z(d.nx+(1:d.nu),:), ...
              e.Z(d.nx+d.nu+(1:d.nlam),:), e.Z(d.nx+d.nu+d.nlam+1:end,:)};
  [e.F, e.G] = m.module ("collocation", e.m.cst, e.points{:});
  last = [c.number; z];
  kept = e;
endfunction

## of each defect what stands by its duration, a column each
function s = sums (c, e)
  s = gsmbp__collocation_rates (c, e.F, e.points{4}) * c.sums';
endfunction

function g = equations (c, e)
  q = c.stages;
  x = e.points{3};
  own = c.stage(c.mesh.rule.own,:);
  left = repmat (c.left, rows (own), 1);
  g = zeros (c.m, 1);
  g(c.residual(:)) = e.F(1:c.nr,q)(:);
  g(c.path(:)) = e.F(c.bounded,q)(:);
  g(c.defect(:)) = (x(:,own(:)) - x(:,left(:)) + e.T(c.of_defect(:)') .* sums (c, e))(:);
endfunction

function g = gradient (c, e)
  k = find (c.goal(c.J(:,1)));
  g = zeros (c.n, 1);
  if (! isempty (k))
    G = reshape (e.G, rows (c.J), c.K)(k,:) .* c.goal(c.J(k,1));
    by_time = c.J(k,2) == 1;
    G(by_time,:) .*= c.tau;
    g = accumarray (c.columns(c.J(k,2),:)(:), (G .* (e.T * c.weights))(:), [c.n, 1]);
  endif
  T = c.K * c.nz + (1:c.nT)';
  g(T) += c.goal_time + c.weights * (c.goal' * e.F)';
endfunction

## weights of the functions: of the rates by the multipliers of the defects, of the goal; without
## the durations an array for each phase
function v = hessian (m, c, e, factor, lambda)
  d = c.d;
  l = find (c.rate);
  Lambda = reshape (lambda(c.defect(:)), d.nx, []);
  bare = zeros (c.nf, c.K, c.nT);
  speeds = zeros (d.nu, c.K, c.nT);
  w = zeros (c.nf, c.K);
  for phase = 1:c.nT
    omega = (Lambda .* (c.of_defect(:)' == phase)) * c.sums;
    bare(:,:,phase) = factor * c.goal * c.weights(phase,:);
    bare(c.rate(l),:,phase) += omega(l,:);
    speeds(:,:,phase) = omega(c.speed,:);
    w += e.T(phase) * bare(:,:,phase);
  endfor
  w(1:c.nr,c.stages) += reshape (lambda(c.residual), size (c.residual));
  w(c.bounded,c.stages) += reshape (lambda(c.path), size (c.path));
  H = m.module ("collocation", e.m.cst, e.points{:}, w);
  v = [c.curved(:,3) .* H(c.curved(:,4))(:)
       c.crossed(:,3) .* e.G(c.crossed(:,4))(:) .* bare(c.crossed(:,5))(:)
       speeds(c.crossed_speeds(:,3))(:)];
endfunction
