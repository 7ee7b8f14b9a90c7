## list = gsmbp__margins (m, t, x, v)
## The margins of the devices of the model M (m.state_margins, above 0 where the device's laws
## hold) that are passed at the times T in the states X under the inputs V (a row for each
## time): a struct array with "text" of the margin, its first "time", its "least" value.

function list = gsmbp__margins (m, t, x, v)
  list = struct ("text", {}, "time", {}, "least", {});
  if (! any (strcmp (m.subroutines, "mar")))
    return;
  endif
  g = s = zeros (numel (t), numel (m.state_margins));
  for k = 1:numel (t)
    [g(k,:), s(k,:)] = m.mar (t(k), x(k,:)', v(k,:)');
  endfor
  for k = 1:columns (g)
    bad = find (! (g(:,k) >= -1e-9 * s(:,k)));   # below that is no rounding error
    if (! isempty (bad))
      list(end+1) = struct ("text", m.state_margins{k}, "time", t(bad(1)), "least", min (g(:,k)));
    endif
  endfor
endfunction
