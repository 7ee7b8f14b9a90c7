## gs.run.warn_of (who, m, s, listed)
## What the result of a run of M does not show by itself: S, its statistics, as warnings.  LISTED:
## how many events the result has.

function warn_of (who, m, s, listed)
  if (s.singular_positions > 0)
    care = "";
    if (! strcmp (s.method, "dp853"))
      care = sprintf (", and %s, unlike dp853, does not watch its accuracy there", s.method);
    endif
    warning ("gsmbp:singular", ["%s: %s passed %d position%s where its constraints lose rank, " ...
                                "the first at t = %.6g s: it may go on in more than one way " ...
                                "there%s"], who, m.name, s.singular_positions, ...
             {"", "s"}{1 + (s.singular_positions > 1)}, s.singular_times(1), care);
  endif
  if (s.singular_positions == 0 && s.loose > 0 && ! strcmp (s.method, "dp853"))
    warning ("gsmbp:singular", ["%s: %s came close to a position where its constraints lose " ...
                                "rank at t = %.6g s: %s, unlike dp853, does not watch its " ...
                                "accuracy there"], who, m.name, s.least_pivot_at, s.method);
  endif
  if (s.angle_singularities > 0)
    joints = "";
    if (! isempty (m.angles))
      joints = [" of " strjoin(m.angles(:)', ", ")];
    endif
    warning ("gsmbp:angles", ["%s: %s came within 0.05 rad of a singularity of its orientation " ...
                              "angles%s at t = %.6g s: choose another sequence of axes or " ...
                              "Euler parameters"], who, m.name,
             joints, s.angle_times(1));
  endif
  for one = s.margins
    warning ("gsmbp:margin", "%s: %s: %s at the least, passed first at t = %.6g s", who, m.name,
             one.said, one.time);
  endfor
  if (isfield (s, "events") && s.events > listed)
    warning ("gsmbp:events", ["%s: %s: there were %d events, the result has the first %d of " ...
                              "them: take shorter runs to have all"], who, m.name, s.events, ...
             listed);
  endif
  if (isfield (s, "held"))
    warn_of_held (who, m, s.held([s.held.samples] > 0));
  endif
  if (isfield (s, "lost") && ! isempty (s.lost))
    one = s.lost(1);
    warning ("gsmbp:derivative", ["%s: %s: no derivatives by %s from t = %.9g s on (event of " ...
                                  "%s): %s; they are NaN from there on"], who, m.name, ...
             strjoin ({s.lost.name}, ", "), one.time, one.event, one.text);
  endif
  if (! isnan (s.stiff.time))
    warn_of_stiffness (who, m, s.method, s.stiff);
  endif
endfunction

function warn_of_stiffness (who, m, method, f)
  remedy = "take method \"radau\"";
  if (! isfield (m, "json") || ! isfield (m.json, "devices") || ! isempty (m.json.devices))
    remedy = [remedy, ", or a reduced variant of the actuator that is so fast"];
  endif
  if (any (strcmp (regexprep (f.state, '_d$', ""), of_modes (m))))
    remedy = "leave that mode of a flexible link out, or take method \"radau\"";
  endif
  if (strcmp (method, "rk4"))
    warning ("gsmbp:stiff", ["%s: %s: at t = %.6g s the step of rk4, %.3g s, is beyond its " ...
                             "limit of stability, %.3g s (largest eigenvalue about %.3g 1/s, " ...
                             "of %s): %s"], who, m.name,
             f.time, f.step, 2.78 / f.eigenvalue, f.eigenvalue, f.state, remedy);
  elseif (strcmp (method, "dp853"))
    warning ("gsmbp:stiff", ["%s: %s: at t = %.6g s the steps of dp853, %.3g s, are bound by " ...
                             "stability, not by accuracy (largest eigenvalue about %.3g 1/s, " ...
                             "of %s): %s"], who, m.name,
             f.time, f.step, f.eigenvalue, f.state, remedy);
  endif
endfunction

function warn_of_held (who, m, list)
  for one = list
    at = "";
    if (! isnan (one.first))
      at = sprintf (", the first at t = %.6g s", one.first);
    endif
    warning ("gsmbp:held", ["%s: %s: the controller %s had no command at %d sample%s%s: the " ...
                            "inputs stayed as they were (the loops do not close at what is " ...
                            "measured or wanted, or the drives cannot give this motion)"], who, ...
             m.name, one.name, one.samples, {"", "s"}{1 + (one.samples != 1)}, at);
  endfor
endfunction

## modal coordinates: those that no joint has; none where the description has no joints
function names = of_modes (m)
  names = {};
  if (! isfield (m, "json") || ! isfield (m.json, "joints"))
    return;
  endif
  names = m.coordinates(:)';
  for joint = gs.model.struct_list (m.json.joints)
    if (! strcmp (joint.type, "section") && ! isempty (joint.coordinates))
      names = setdiff (names, cellstr (joint.coordinates));
    endif
  endfor
endfunction
