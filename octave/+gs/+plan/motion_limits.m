## limits = gs.plan.motion_limits (who, m, o, n)
## The limits of gsmbp_retime as rows [least, largest]: speed and effort of N coordinates, input (by
## default those of the scene).

function limits = motion_limits (who, m, o, n)
  limits = struct ();
  told = "limit input";
  if (isempty (o.input))
    o.input = of_scene (m);
    told = "limits of the inputs in the scene";
  endif
  sizes = struct ("speed", n, "effort", n, "input", m.sizes.nv);
  for name = fieldnames (sizes)'
    what = {["limit " name{1}], told}{1 + strcmp(name{1}, "input")};
    limits.(name{1}) = gs.given.given_bounds (who, what, o.(name{1}), sizes.(name{1}));
  endfor
  if (isempty (o.speed) && isempty (o.effort) && isempty (o.input))
    error ("%s: expected a limit: speed, effort or input", who);
  endif
  if (any (isfinite (limits.input(:))) && ! any (strcmp (m.subroutines, "cmq")) && m.order > 2)
    error (["%s: %s: expected the subroutine CMQ, which %s has not: %s (\"input\", Inf leaves " ...
            "them out)"], who, told, m.name, gs.text.why_left_out (m, "quasi_static"));
  endif
endfunction

## none where it gives none
function list = of_scene (m)
  list = gs.model.scene_limits (m, m.inputs);
  if (! any (isfinite (list(:))))
    list = [];
  endif
endfunction
