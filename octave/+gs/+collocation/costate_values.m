## l = gs.collocation.costate_values (s)
## The derivatives of the goal by the states at the points: the weights of the rates by the
## multipliers of the defects beside those of the integral; where no stage stands at the beginning
## of an interval what its defects have by the state there, which is more accurate.

function l = costate_values (s)
  c = s.c;
  Lambda = reshape (s.multipliers(c.defect(:)), c.d.nx, []);
  l = ((Lambda * c.sums) ./ sum (c.weights, 1))';
  if (! any (c.stages == 1))
    own = numel (c.mesh.rule.own);
    l(c.left,:) = -sum (reshape (Lambda, c.d.nx, own, []), 2)(:,:)';
  endif
endfunction
