## p = gs.linear.steady_problem (p, names, free)
## The problem P of gs.linear.rest_problem where the coordinates NAMES run on at the constant speeds
## of its state, which are unknowns if they are among the states FREE.  Coordinates that a motion
## drives with time run on with it.

function p = steady_problem (p, names, free)
  [m, d] = deal (p.m, p.m.sizes);
  pairs = zeros (0, 2);
  for name = cellstr (names)(:)'
    pairs(end+1,:) = gs.given.speed_and_value (p.who, m, "steady", name{1});
  endfor
  running = pairs(:,1)';
  [q, u] = gs.linear.free_velocities (m, p.t, p.x, pairs(:,2)');
  p.x = with_dependent_speeds (p, u);
  without = no_effect (p);
  p.running = unique ([running, without, driven(p, u)]);
  p.steady = pairs;
  kept = [p.held(:)', d.nq + pairs(:,2)'];
  kept = setdiff (kept, free);
  ## what follows from the constraints stays an unknown
  fixed = [intersect(kept, [d.nq + u, d.nq + d.nu + 1:d.nx]), intersect(q, p.running), ...
           intersect(q, p.held)];
  p.own = setdiff (1:d.nx, fixed);
  still = setdiff (1:d.nq, p.running);
  p.rows = [still, d.nq + u, d.nq + d.nu + 1:d.nx];
  p.free_coordinates = q;
  p.free_speeds = u;
endfunction

## the state with the speeds that follow from those of the numbers U
function x = with_dependent_speeds (p, u)
  [m, d, x] = deal (p.m, p.m.sizes, p.x);
  if (d.nlam == 0)
    return;
  endif
  s = d.nq + (1:d.nu);
  [~, phit, H] = m.con (p.t, x(1:d.nq), x(s));
  x(s) = [H; eye(d.nu)(u,:)] \ [-phit; x(d.nq + u)];
endfunction

## coordinates that move with time alone, while the speeds of the numbers U are zero
function k = driven (p, u)
  d = p.m.sizes;
  p.x(d.nq + u) = 0;
  x = with_dependent_speeds (p, u);
  k = find (p.m.rhs (p.t, x, p.v)(1:d.nq) != 0)' * (d.nlam > 0);
  k = k(k > 0);
endfunction

## coordinates on which neither rates nor constraints depend
function k = no_effect (p)
  [m, d] = deal (p.m, p.m.sizes);
  A = m.jac (p.t, p.x, p.v)(d.nq + 1:end,1:d.nq);
  if (d.nlam > 0)
    [DP, DV] = m.tan (p.t, p.x);
    A = [A; DP; DV];
  endif
  k = setdiff (find (! any (A, 1)), m.orientation(:)');
endfunction
