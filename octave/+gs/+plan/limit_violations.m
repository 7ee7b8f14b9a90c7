## list = gs.plan.limit_violations (m, r, texts, limits)
## What a motion asks that cannot be given, along the result R of gsmbp_inverse: margins (TEXTS)
## that are not above 0, inputs beyond their LIMITS (rows [least, largest]); a struct array: text,
## first time, least value (of an input: what its limit leaves), said (a sentence).

function list = limit_violations (m, r, texts, limits)
  list = struct ("text", {}, "time", {}, "least", {}, "said", {});
  for k = 1:numel (texts)
    bad = find (! (r.margins(:,k) > 0));
    if (! isempty (bad))
      least = min (r.margins(:,k));
      list(end+1) = struct ("text", texts{k}, "time", r.t(bad(1)), "least", least, "said", ...
                            sprintf ("%s: not from t = %.4g s on: expected above 0, found %.4g", ...
                                     texts{k}, r.t(bad(1)), least));
    endif
  endfor
  for k = 1:columns (r.v)
    left = min (r.v(:,k) - limits(k,1), limits(k,2) - r.v(:,k));
    bad = find (left < 0);
    if (! isempty (bad))
      list(end+1) = struct ("text", m.inputs{k}, "time", r.t(bad(1)), "least", min (left), ...
                            "said", sentence (m, r, k, limits(k,:), left, r.t(bad(1))));
    endif
  endfor
endfunction

function text = sentence (m, r, k, limits, left, time)
  [~, worst] = min (left);
  side = 1 + (r.v(worst,k) > limits(2));
  unit = m.units.inputs{k};
  text = sprintf (["%s takes %.4g %s at t = %.4g s%s, %s its limit of %.4g %s from t = %.4g s " ...
                   "on"], m.inputs{k}, r.v(worst,k), unit, r.t(worst), driven (m, m.inputs{k}), ...
                  {"below", "above"}{side}, limits(side), unit, time);
endfunction

## the coordinates that the device of an input drives
function text = driven (m, name)
  text = "";
  if (! isfield (m.json, "devices"))
    return;
  endif
  for a = gs.model.struct_list (m.json.devices)
    if (strcmp (a.name, strtok (name, ".")) && ! isempty (a.drives))
      text = [" to move " strjoin(m.coordinates(a.drives(:))', ", ")];
    endif
  endfor
endfunction
