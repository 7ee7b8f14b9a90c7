## list = gs.collocation.active_limits (m, p, s)
## Bounds of the solution S with multipliers: of inputs, states, outputs, the duration and the
## parameters.

function list = active_limits (m, p, s)
  c = s.c;
  d = c.d;
  list = struct ("name", {}, "bound", {}, "value", {}, "from", {}, "until", {}, "multiplier", {});
  z = reshape (s.zu(1:c.K*c.nz) - s.zl(1:c.K*c.nz), c.nz, c.K);
  names = [m.states(:); cell(d.nu + d.nlam, 1); m.inputs(:)];
  for l = [1:d.nx, c.nz-d.nv+1:c.nz]
    bound = z(l,:);
    bound(s.low((0:c.K-1)*c.nz+l) == s.high((0:c.K-1)*c.nz+l)) = 0;
    list = [list, of_one(names{l}, bound, p.low(l), p.high(l), s)];
  endfor
  for k = 1:numel (p.outputs)
    bound = zeros (1, c.K);
    bound(c.stages) = s.multipliers(c.path(k,:));
    list = [list, of_one(m.outputs{p.outputs(k).number}, bound, p.outputs(k).low, ...
                         p.outputs(k).high, s)];
  endfor
  globals = (c.K*c.nz+1):c.n;
  names = [repmat({"time"}, 1, c.nT), c.parameters(:)'];
  for k = 1:numel (globals)
    g = globals(k);
    l = s.zu(g) - s.zl(g);
    if (s.low(g) < s.high(g) && abs (l) > 1e-6 * (1 + abs (s.J)))
      limits = [s.low(g), s.high(g)];
      list(end+1) = struct ("name", names{k}, "bound", {{"least", "largest"}{1 + (l > 0)}}, ...
                            "value", limits(1 + (l > 0)), "from", NaN, "until", NaN, ...
                            "multiplier", abs (l));
    endif
  endfor
endfunction

## one quantity at both its bounds
function list = of_one (name, multiplier, low, high, s)
  list = struct ("name", {}, "bound", {}, "value", {}, "from", {}, "until", {}, "multiplier", {});
  limits = [low, high];
  words = {"least", "largest"};
  for side = 1:2
    l = max (0, (2 * side - 3) * multiplier);
    on = l > 1e-6 * (1 + abs (s.J)) & l > 1e-4 * max (l);
    if (any (on))
      list(end+1) = struct ("name", name, "bound", words{side}, "value", limits(side), ...
                            "from", min (s.times(on)), "until", max (s.times(on)), ...
                            "multiplier", sum (l));
    endif
  endfor
endfunction
