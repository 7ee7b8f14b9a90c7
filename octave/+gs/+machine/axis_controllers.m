## c = gs.machine.axis_controllers (who, s, axes_, pose, laws, limits, feedforward)
## One controller of the laws of all axes about a pose, as of gsmbp_control: it reads the
## coordinates, its references are theirs and, with FEEDFORWARD, the voltages that the motion
## takes.

function c = axis_controllers (who, s, axes_, pose, laws, limits, feedforward)
  n = numel (axes_);
  o = struct ("measured", {{axes_.output}}, "inputs", {pose.model.inputs([axes_.input])'}, ...
              "integral", {{}}, "track", {{}}, "reduced", "auto", "drop", {{}}, "period", ...
              s.period, "delay", s.delay);
  p = gs.control.sampled_plant (who, gs.control.linear_plant (who, pose.model, pose.trim, o), o);
  c = struct ("A", [], "B", zeros (0, 2 * n), "C", zeros (n, 0), "D", zeros (n, 2 * n), "G", []);
  for j = 1:n
    law = laws(j).law;
    own = [j, n + j];
    z = rows (c.A) + (1:rows (law.A));
    c.A = blkdiag (c.A, law.A);
    c.G = blkdiag (c.G, law.G);
    c.B(z,own) = law.B;
    c.C(j,z) = law.C;
    c.D(j,own) = law.D;
  endfor
  [c.name, c.method, c.period, c.delay] = deal ("ctl", "pid", s.period, s.delay);
  for field = {"measured", "driven", "y0", "u0", "x0", "plant"}
    c.(field{1}) = p.(field{1});
  endfor
  c.references = strcat (c.measured, "_ref");
  c.units = pose.model.units.outputs(gs.given.places_of (c.measured, pose.model.outputs))(:);
  c.r0 = c.y0;
  if (feedforward)
    c.B = [c.B, zeros(rows (c.B), n)];
    c.D = [c.D, eye(n)];
    c.references = [c.references; strcat({axes_.motor}', "_ff")];
    c.units = [c.units; pose.model.units.inputs([axes_.input])(:)];
    c.r0 = [c.r0; c.u0];
  endif
  c.limits = gs.given.two_limits (who, limits(:), c.driven, c.u0);
  c.step_in = repmat (s.encoder, n, 1);
  c.step_out = repmat (s.step_out, n, 1);
endfunction
