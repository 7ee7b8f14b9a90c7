## r = gs.collocation.motion_result (m, s, found)
## What gsmbp_collocate gives back of a solution S, a row for each point, with the fields of FOUND.

function r = motion_result (m, s, found)
  c = s.c;
  r = found;
  r.t = s.times(:);
  r.x = s.x';
  s = ahead (c, s);
  r.v = s.v';
  r.ud = s.ud';
  r.lambda = s.lambda';
  r.y = s.F(c.output+1:end,:)';
  if (! any (c.stages == 1))   # they stand for inputs that are none
    n = gs.collocation.model_with (m, c, s.parameters);
    r.y(1,:) = gs.run.output_values (n, r.t(1), r.x(1,:), r.v(1,:));
  endif
  r.T = sum (s.T);
  r.goal = s.J;
  r.parameters = cell2struct (num2cell (s.parameters(:)), c.parameters(:), 1);
  r.input = inputs (c, s);
  r.motion = motion (m, c, s);
  r.costates = gs.collocation.costate_values (s);
  r.error = s.error;
  r.ended = s.ended;
endfunction

## Radau's rule has nothing at the start: the polynomial of the first interval
function s = ahead (c, s)
  if (any (c.stages == 1))
    return;
  endif
  q = c.stage(:,1);
  w = gs.collocation.lagrange_basis (c.mesh.rule.c, 0);
  for name = {"v", "ud", "lambda"}
    s.(name{1})(:,1) = s.(name{1})(:,q) * w;
  endfor
endfunction

## polynomials of order 2 through the stages
function pp = inputs (c, s)
  n = columns (c.left);
  nv = c.d.nv;
  pp = [];
  if (nv == 0)
    return;
  endif
  coefs = zeros (nv, n, 3);
  for k = 1:n
    begin = s.times(c.left(k));
    h = s.times(c.stage(end,k)) - begin;
    V = (c.mesh.rule.c(:) .^ [2 1 0]) \ s.v(:,c.stage(:,k))';
    coefs(:,k,:) = (V ./ [h^2; h; 1])';
  endfor
  pp = mkpp (s.times([c.left, c.K]), coefs, nv);
endfunction

## polynomials of order 5 with the places, speeds and accelerations of the points
function pp = motion (m, c, s)
  pp = [];
  d = c.d;
  plain = d.nq == d.nu && max (abs (s.F(c.nr+(1:d.nq),:) - s.x(d.nq+(1:d.nu),:))(:)) == 0;
  if (! plain)
    return;
  endif
  planned = 1:d.nq;
  if (d.nlam > 0)
    planned = m.actuated(:)';
  endif
  if (isempty (planned))
    return;
  endif
  t = s.times;
  h = reshape (diff (t), 1, []);
  q = s.x(planned,:);
  u = s.x(d.nq+planned,:) ;
  a = s.ud(planned,:);
  [q0, u0, a0] = deal (q(:,1:end-1), u(:,1:end-1), a(:,1:end-1));
  e = q(:,2:end) - (q0 + u0 .* h + a0 .* h.^2 / 2);   # what the cubic and higher terms give
  f = u(:,2:end) - (u0 + a0 .* h);
  g = a(:,2:end) - a0;
  k5 = (12 * e - 6 * f .* h + g .* h.^2) ./ (2 * h.^5);
  k4 = (-15 * e + 7 * f .* h - g .* h.^2) ./ h.^4;
  k3 = (20 * e - 8 * f .* h + g .* h.^2) ./ (2 * h.^3);
  n = numel (planned);
  pp = mkpp (t, cat (3, k5, k4, k3, a0 / 2, u0, q0), n);
endfunction
