## f = gs.collocation.node_rates (c, F, ud)
## The rates of the states at all points of a program C: of coordinates and devices among the
## functions F of DAE, of speeds the accelerations UD.

function f = node_rates (c, F, ud)
  f = zeros (c.d.nx, c.K);
  l = find (c.rate);
  f(l,:) = F(c.rate(l),:);
  f(c.speed,:) = ud;
endfunction
