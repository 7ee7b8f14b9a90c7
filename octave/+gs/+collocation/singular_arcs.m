## arcs = gs.collocation.singular_arcs (p, s, list, share)
## Singular arcs (LIST) of a solution S as gs.collocation.input_roughness takes them: from 0 to 1,
## less one interval where another arc begins; the weight is a SHARE of the size of the
## Hamiltonian's parts by the square of the input's width.

function arcs = singular_arcs (p, s, list, share)
  c = s.c;
  rates = gs.collocation.node_rates (c, s.F, s.ud);
  size_ = mean (sum (abs (gs.collocation.costate_values (s)' .* rates)(:,c.stages), 1)) * sum (s.T);
  arcs = struct ("input", {}, "from", {}, "until", {}, "weight", {});
  ends = s.t(c.stage(end,:));
  begins = s.t(c.left);
  for one = list
    a = (one.from - s.times(1)) / sum (s.T);
    b = (one.until - s.times(1)) / sum (s.T);
    if (a <= ends(1))
      a = 0;
    else
      a = ends(find (ends >= a, 1));
    endif
    if (b < begins(end))
      b = begins(find (begins <= b, 1, "last"));
    endif
    span = gs.collocation.input_width (s.v(one.input,c.stages));
    arcs(end+1) = struct ("input", one.input, "from", a, "until", b, "weight", ...
                          share * size_ / span ^ 2);
  endfor
endfunction
