## x0 = bench_start (m, c): the start of case C: the scene's start values and the speeds of the
## case, moved onto the constraints. C.speeds: pairs of what the names of some speeds begin with,
## and a speed.

function x0 = bench_start (m, c)
  x0 = m.initial;
  for k = 1:2:numel (c.speeds)
    x0(m.sizes.nq + find (strncmp (m.speeds, c.speeds{k}, numel (c.speeds{k})))) = c.speeds{k+1};
  end
  if (m.sizes.nlam > 0)
    x0 = gsmbp_assemble (m, x0, "hold", c.hold);
  end
end
