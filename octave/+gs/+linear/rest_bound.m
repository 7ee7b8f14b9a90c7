## part = gs.linear.rest_bound (p, step)
## How much of STEP keeps the unknowns of P within their bounds.

function part = rest_bound (p, step)
  n = sum (p.own <= p.m.sizes.nq);
  largest = 10 * ones (numel (step), 1);
  largest(strcmp (p.m.units.coordinates(p.own(1:n)), "rad")) = 0.5;
  largest(ismember (p.own, p.m.orientation(:))) = 0.25;
  part = min ([1; largest ./ max(abs (step), realmin)]);
endfunction
