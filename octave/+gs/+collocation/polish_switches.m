## [s, switches] = gs.collocation.polish_switches (who, m, p, s, o)
## A solution S whose inputs jump between their limits solved once more with the durations between
## the jumps as unknowns and the inputs held at their limits; SWITCHES: the times of these jumps
## [s]. S stays as it is where its inputs do otherwise, where the scene depends on time, or where
## the other solution is none, or against the minimum principle.

function [s, switches] = polish_switches (who, m, p, s, o)
  switches = zeros (0, 1);
  by_time = any (s.c.J(:,2) == 1 & s.c.J(:,1) <= s.c.output);
  time_alone = p.goal_time > 0 && isempty (p.goal) ...
               && ! any ([p.final.x; p.final.y; p.own.linear]) && isempty (p.own.products);
  if (! (s.solved && o.polish) || ! time_alone || by_time || ! isempty (p.outputs) || s.c.nT > 1)
    return;
  endif
  [levels, begins] = phases (p, s);
  if (isempty (levels) || numel (begins) < 2)
    return;
  endif
  mesh = struct ("rule", gs.collocation.quadrature_rule ("radau"), "breaks", pieces (s, begins));
  q = p;
  if (isfield (q, "singular"))
    q = rmfield (q, "singular");
  endif
  q.held = levels;
  q.T = [0, p.T(2)];
  new = s;
  new.T = diff ([begins, 1]) * s.T;
  for k = 0:o.refinements
    new = gs.collocation.solve_mesh (who, m, q, mesh, new, o);
    if (! new.solved || sum (new.T) > s.T * (1 + 1e-3) || sum (new.T) < p.T(1))
      return;
    endif
    [new.error, errors] = gs.collocation.mesh_errors (m, new);
    if (new.error <= o.accuracy)
      break;
    endif
    mesh = gs.collocation.finer_mesh (mesh, errors, o.accuracy);
  endfor
  if (new.error <= o.accuracy && is_optimal (new, levels, p))
    s = new;
    switches = cumsum (new.T(1:end-1))' + p.t0;
  endif
endfunction

## the intervals of S cut at the beginnings of phases, four or more in each
function breaks = pieces (s, begins)
  ends = [begins(2:end), 1];
  breaks = zeros (3, 0);
  for k = 1:numel (begins)
    inner = (s.t([s.c.left, s.c.K]) - begins(k)) / (ends(k) - begins(k));
    b = [0, inner(inner > 0.02 & inner < 0.98), 1];
    if (numel (b) < 5)
      b = (0:4) / 4;
    endif
    breaks = [breaks, [k * ones(1, numel (b) - 1); b(1:end-1); b(2:end)]];
  endfor
endfunction

## the inputs of each phase, at a limit each, and where they begin (of the duration 1); [] where
## more than one point in eight lies between the limits
function [levels, begins] = phases (p, s)
  c = s.c;
  v = c.nz - c.d.nv + (1:c.d.nv);
  low = p.low(v);
  high = p.high(v);
  levels = begins = [];
  if (! all (isfinite ([low; high])))
    return;
  endif
  q = c.stages;
  share = (s.v(:,q) - low) ./ (high - low);
  between = any (share > 0.05 & share < 0.95, 1);
  if (sum (between) > numel (between) / 8)
    return;
  endif
  up = share > 0.5;
  change = [true, any(diff (up, 1, 2), 1)];
  at = s.t(q);
  begins = [0, (at(find (change(2:end))) + at(find (change(2:end)) + 1)) / 2];
  levels = low + (high - low) .* up(:,change);
endfunction

## the minimum principle: no input gains by leaving its limit
function yes = is_optimal (s, levels, p)
  c = s.c;
  J = s.f ("places"){1};
  J = sparse (J(:,1), J(:,2), s.f ("jac", s.z), c.m, c.n);
  g = reshape ((s.f ("grad", s.z) + J' * s.multipliers)(1:c.K*c.nz), c.nz, c.K);
  v = c.nz - c.d.nv + (1:c.d.nv);
  q = c.stages;
  g = g(v,q);
  at_high = levels(:,c.phase(q)) == p.high(v);
  g(at_high) *= -1;
  yes = all (g(:) >= -1e-3 * max (abs (g(:))));
endfunction
