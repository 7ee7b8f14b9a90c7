## P = gs.collocation.input_roughness (c, arcs)
## The form that inputs on singular ARCS (gs.collocation.find_singular; times from 0 to 1) are made
## smooth by: the square of their distance from the cubic through the points of three intervals, for
## each three in turn within the arc, times the arc's weight. Rows [row, column, value], lower
## triangle of a transcription C.

function P = input_roughness (c, arcs)
  P = sparse (c.n, c.n);
  for arc = arcs
    k = find (c.tau(c.left) >= arc.from - 1e-9 & c.tau(c.stage(end,:)) <= arc.until + 1e-9);
    for i = 2:numel (k) - 1
      q = intersect (c.stage(:,k(i-1:i+1))(:), c.stages);
      t = c.tau(q)(:);
      A = ((t - mean (t)) / (t(end) - t(1))) .^ (0:3);
      off = eye (numel (q)) - A * pinv (A);
      z = c.at (c.nz - c.d.nv + arc.input, q(:)');
      P(z,z) += arc.weight * c.h(k(i)) / numel (q) * off;
    endfor
  endfor
  [row, column, value] = find (tril (P));
  P = [row(:), column(:), value(:)];
endfunction
