## poses = gs.machine.work_poses (m, axes_, tasks, s, signs)
## Where the controllers are looked at: trims of the model M at rest at five times of each task,
## its driven coordinates held there, without dry friction and losses of the gears (at rest
## their slopes would pretend damping that is not there in motion), at the corner SIGNS of the
## tolerances of the specification S ([]: at the nominal values). A row of structs: model, trim,
## task, time, corner (in words, "": nominal).

function poses = work_poses (m, axes_, tasks, s, signs)
  smooth = struct ();
  for a = axes_
    if (isfield (m.par, a.par.eta))
      smooth.(a.par.eta) = 1;
    endif
    if (isfield (m.par, a.par.Tc))
      smooth.(a.par.Tc) = 1e-9;
    endif
  endfor
  smooth = gsmbp_set (gsmbp_set (m, smooth), s.linear);
  poses = struct ("model", {}, "trim", {}, "task", {}, "time", {}, "corner", {});
  said = "";
  if (! isempty (signs))
    said = [" at the corner " gs.proof.corner_text(s, signs)];
  endif
  for i = 1:numel (tasks)
    one = at_corner (gsmbp_set (smooth, tasks(i).values), s, signs);
    t = linspace (tasks(i).start, tasks(i).stop, 5);
    r = gsmbp_inverse (one, tasks(i).plan, t, "quasistatic", true);
    for k = 1:numel (t)
      x = m.initial;
      x(1:m.sizes.nq) = r.q(k,:);
      e = gsmbp_trim (one, x, [], "hold", {axes_.coordinate}, "free", m.inputs([axes_.input]));
      poses(end+1) = struct ("model", one, "trim", e, "task", tasks(i).name, "time", t(k), ...
                              "corner", said);
    endfor
  endfor
endfunction

function m = at_corner (m, s, signs)
  for i = 1:numel (signs)
    name = s.tolerances{i,1};
    m = gsmbp_set (m, name, m.par.(name) * (1 + signs(i) * s.tolerances{i,2}));
  endfor
endfunction
