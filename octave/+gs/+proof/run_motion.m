## r = gs.proof.run_motion (d, m, mc, i, own, option, value, ...)
## A run of the machine of the design D with its controller (model MC; M: the same parameters
## without it) through the task OWN, the i-th, with the references of its controller's computer.
## Also planned and error, a column for each axis, and whether it ended where it should.

function r = run_motion (d, m, mc, i, own, varargin)
  ref = d.references{i};
  table = zeros (numel (ref.t), mc.sizes.nv);
  table(:,gs.given.places_of (strcat ("ctl.", {d.axes.output}, "_ref"), mc.inputs)) = ref.planned;
  fed = gs.given.places_of (strcat ("ctl.", {d.axes.motor}, "_ff"), mc.inputs);
  if (all (fed))
    table(:,fed) = ref.voltages;
  endif
  [~, x0] = gs.proof.motion_command (m, d.axes, own, own.start);
  [r, info] = gsmbp_simulate (gsmbp_set (mc, own.values), x0(1,:)', ref.t, "input", ...
                              gsmbp_plan ("table", ref.t, table, 1), "rtol", 1e-8, ...
                              varargin{:});
  r.ended = info == 0;
  r.planned = ref.planned(1:rows (r.x),:);
  r.error = r.x(:,[d.axes.k]) - r.planned;
endfunction
