## kept = gsmbp__kept (who, m, words)
## What WORDS, as "peak motor.i", keep of a run of the model M: a struct array with what, name, unit
## and of (t, z), a number for each column of z, a row for each time t.

function kept = gsmbp__kept (who, m, words)
  if (isempty (words))
    words = cellfun (@(name) ["final " name], {m.outputs, m.states}{1 + isempty(m.outputs)}(:)', ...
                     "UniformOutput", false);
  endif
  ways = struct ("final", @(t, z) z(end,:), "peak", @(t, z) max (abs (z), [], 1), ...
                 "max", @(t, z) max (z, [], 1), "min", @(t, z) min (z, [], 1), ...
                 "mean", @(t, z) trapz (t, z) / (t(end) - t(1)), ...
                 "rms", @(t, z) sqrt (trapz (t, z .^ 2) / (t(end) - t(1))));
  names = [m.states(:); m.inputs(:); m.outputs(:)]';
  units = [m.units.states(:); m.units.inputs(:); m.units.outputs(:)]';
  kept = struct ("what", {}, "name", {}, "unit", {}, "of", {});
  for word = cellstr (words)(:)'
    parts = regexp (strtrim (word{1}), '^(\w+)\s+(.*)$', "tokens", "once");
    if (isempty (parts) || ! isfield (ways, parts{1}))
      error ("%s: option keep: expected one of %s and a name, found %s", who, ...
             strjoin (fieldnames (ways)', ", "), gsmbp__shown (word{1}));
    endif
    k = find (strcmp (names, parts{2}), 1);
    if (isempty (k))
      error ("%s: option keep: unknown %s", who, gsmbp__unknown (parts{2}, names));
    endif
    kept(end+1) = struct ("what", word{1}, "name", parts{2}, "unit", units{k}, "of", ...
                          ways.(parts{1}));
  endfor
endfunction
