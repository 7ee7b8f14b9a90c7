## [ip, rp] = gsmbp__sampled (who, m, o, times, ip, rp)
## The plan of the samples (share/fortran/inputs/gssmp.f) behind the arrays IP and RP of
## gsinp.f, where the scene M has sampled devices.  O: the options of
## gsmbp_simulate (memory, held, samples); periods and delays are filled in by
## the module.

function [ip, rp] = gsmbp__sampled (who, m, o, times, ip, rp)
  d = m.sizes;
  nc = numel (m.controllers);
  if (nc == 0)
    if (! isempty (o.memory))
      error ("%s: option memory: %s has no sampled devices", who, m.name);
    endif
    return;
  endif
  if (! any (strcmp (m.subroutines, "ctl")))
    error (["%s: %s has sampled devices, but was emitted without the subroutine CTL " ...
            "(request control)"], who, m.name);
  endif
  [period, delay] = m.module ("ctp", m.cst);
  if (! all (period > 0) || ! all (delay >= 0))
    k = find (! (period > 0) | ! (delay >= 0), 1);
    error ("%s: %s: period and delay must be > 0 and >= 0; found %g s and %g s", who, ...
           m.controllers(k).name, period(k), delay(k));
  endif
  memory = o.memory;
  if (isempty (memory))
    memory = vertcat (m.controllers.starts);
  endif
  if (! (isnumeric (memory) && numel (memory) == d.nxk && all (isfinite (memory(:)))))
    error ("%s: option memory: expected %d finite numbers", who, d.nxk);
  endif
  check_memory (who, m, double (memory(:)'));
  held = vertcat (m.controllers.outputs);
  ## the sample k is at k*period; a start that differs from one by rounding only is one
  k = round (times(1) ./ period);
  k(abs (k .* period - times(1)) > 8 * eps * abs (times(1))) = NaN;
  k(isnan (k)) = ceil (times(1) ./ period(isnan (k)));
  if (any (times(end) ./ period > 2e9))
    error ("%s: more than 2e9 samples", who);
  endif
  places = sum ((delay > 0) .* (floor (delay ./ period + 1e-9) + 2));
  instants = 0;
  if (o.samples)
    instants = sum ((1 + (delay > 0)) .* (floor ((times(end) - times(1)) ./ period) + 2));
  endif
  again = double ([m.controllers.again])(:);
  counts = cellfun (@numel, {m.controllers.outputs})(:);
  plan = [nc; d.nxk; d.ny; numel(held); places; instants; 0; 0; 0; 0; k; counts; again; held; ...
          zeros(places, 1)];
  first = numel (ip) + 1;
  ip(23:27) = [numel(held), first + 10 + 3 * nc, numel(rp) + 2 * nc + 1, first, numel(rp) + 1];
  ip = [ip, plan'];
  start = zeros (1, d.nv);
  if (isnumeric (o.input) && numel (o.input) == d.nv)
    start = double (o.input(:)');
  endif
  rp = [rp, period', delay', start(held), double(memory(:)')];
endfunction

## what the entries say of a memory that can be
function check_memory (who, m, memory)
  for one = m.controllers
    own = num2cell (memory(1:numel (one.memory)));
    memory(1:numel (one.memory)) = [];
    for rule = gsmbp__rows (one, "possible")
      letters = sprintf (", p%d", 1:numel (own))(3:end);
      if (str2func (sprintf ("@(%s) %s", letters, rule{1}.value)) (own{:}) < 0)
        pairs = cellfun (@(name, x) sprintf ("%s = %.6g", name, x), one.memory(:)', own, ...
                         "UniformOutput", false);
        error ("%s: option memory: %s: expected %s; found %s", who, one.name, rule{1}.text, ...
               strjoin (pairs, ", "));
      endif
    endfor
  endfor
endfunction
