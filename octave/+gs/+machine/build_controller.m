## [c, mc, smooth] = gs.machine.build_controller (who, d, laws, feedforward)
## The controller of the LAWS of all axes of the design D, the machine with it, and the same
## without converters, whose motion has derivatives.

function [c, mc, smooth] = build_controller (who, d, laws, feedforward)
  c = gs.machine.axis_controllers (who, d.asked, d.axes, d.poses(1), laws, [d.motors.V_max], ...
                                   feedforward);
  place = {"directory", d.model.directory, "parameters", d.model.par};
  mc = gsmbp_build (d.model.name, "controller", c, place{:});
  smooth = mc;
  if (any ([c.step_in; c.step_out] > 0))
    c1 = c;
    [c1.step_in, c1.step_out] = deal (0 * c.step_in, 0 * c.step_out);
    smooth = gsmbp_build (d.model.name, "controller", c1, place{:});
  endif
endfunction
