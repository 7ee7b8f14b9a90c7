## list = gsmbp__margins (m, t, x, v)
## The margins of the devices of the model M (m.state_margins, above 0 where the device's laws
## hold) that are passed at the times T in the states X under the inputs V (a row for each
## time): a struct array with "text" of the margin, its first "time", its "least" value, and the
## sentence "said", with the states and parameters that it is made of.  The one judge of runs,
## starts and equilibria.

function list = gsmbp__margins (m, t, x, v)
  list = struct ("text", {}, "time", {}, "least", {}, "said", {});
  if (! any (strcmp (m.subroutines, "mar")))
    return;
  endif
  [g, s] = m.module ("margins", m.cst, numel (t), t(:), x, v);
  g = g';
  s = s';
  rounding = gsmbp__run_limit ("margin_rounding");
  for k = find (any (! (g >= -rounding * s), 1))
    passed = @(i) ! at_it (m, t(i), x(i,:)', v(i,:)', k);
    [least, i] = min (g(:,k));
    if (any (isnan (g(:,k))))
      i = find (isnan (g(:,k)), 1);
      least = NaN;
    endif
    if (passed (i))
      first = find (! (g(:,k) >= -rounding * s(:,k)))';
      while (! passed (first(1)))
        first(1) = [];
      endwhile
      list(end+1) = struct ("text", m.state_margins{k}, "time", t(first(1)), "least", least, ...
                            "said", sentence (m, x(i,:), k, least));
    endif
  endfor
endfunction

## true if the margin holds where one state is moved a little (limits.h): what steps of an
## integrator or a projection leave is no fault
function yes = at_it (m, t, x, v, k)
  yes = false;
  for step = [diag(m.nominal), -diag(m.nominal)] * gsmbp__run_limit ("margin_near")
    yes = yes || m.mar (t, x + step, v)(k) >= 0;
  endfor
endfunction

function text = sentence (m, x, k, least)
  row = gsmbp__rows (m.json, "margin_values");
  row = row{k};
  states = double (row.states(:))';
  pairs = arrayfun (@(i) sprintf ("%s = %.6g", m.states{i}, x(i)), states, ...
                    "UniformOutput", false);
  if (! isempty (row.parameters))
    own = cellfun (@(name) sprintf ("%s = %.6g", name, m.par.(name)), ...
                   cellstr (row.parameters)(:)', "UniformOutput", false);
    pairs = [pairs, own];
  endif
  text = sprintf ("%s: expected above 0, found %.6g", m.state_margins{k}, least);
  if (! isempty (pairs))
    text = sprintf ("%s (%s)", text, strjoin (pairs, ", "));
  endif
endfunction
