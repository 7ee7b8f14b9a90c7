## pp = gs.plan.law_pieces (laws, q, begin)
## Laws (as of gs.plan.speed_profile) of several coordinates from positions Q and the time BEGIN on,
## as one piecewise polynomial; one that ends first stays.

function pp = law_pieces (laws, q, begin)
  ends = arrayfun (@(l) {[0, cumsum(l.durations)]}, laws(:)');
  T = max ([laws.T]);
  breaks = unique ([ends{:}, T]);
  breaks([diff(breaks) <= 8 * eps * T, false]) = [];
  if (T == 0)
    pp = mkpp (begin + [0, 0], reshape (q, [], 1, 1), numel (q));
    return;
  endif
  middle = (breaks(1:end-1) + breaks(2:end)) / 2;
  coefs = zeros (numel (laws), numel (middle), 4);
  for i = 1:numel (laws)
    l = laws(i);
    for p = 1:numel (middle)
      k = find (middle(p) < ends{i}(2:end), 1);
      if (isempty (k))
        coefs(i,p,4) = l.switch_q(end);
      else
        c = [l.jerks(k) / 6, l.accelerations(k) / 2, l.switch_v(k), l.switch_q(k)];
        coefs(i,p,:) = gs.plan.shifted_polynomial (c, breaks(p) - ends{i}(k));
      endif
    endfor
    coefs(i,:,4) += q(i);
  endfor
  pp = mkpp (begin + breaks, coefs, numel (laws));
endfunction
