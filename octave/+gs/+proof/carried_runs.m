## runs = gs.proof.carried_runs (d, names)
## Runs of all tasks of the machine of the design D that carry derivatives by the parameters
## NAMES, for a change by their own value: slopes (times x states x names), and voltage_slopes,
## those of the voltages of the axes: of the controller's sums, 0 where a voltage stands at its
## limit.

function runs = carried_runs (d, names)
  for i = 1:numel (d.tasks)
    own = d.tasks(i);
    values = gsmbp_set (d.model, own.values).par;
    size_ = cellfun (@(name) values.(name), names);
    ## with the parameter the machine starts elsewhere, its currents hold it
    r = gs.proof.run_motion (d, d.model, d.machine, i, own, "sensitivity", names, "dx0", ...
                             start_slopes (d, own, names, size_));
    for k = 1:numel (names)
      r.slopes(:,:,k) = r.dx.(names{k}) * size_(k);
    endfor
    r.voltage_slopes = voltages (d, r);
    runs{i} = r;
  endfor
endfunction

function S = start_slopes (d, own, names, size_)
  S = zeros (d.model.sizes.nx, numel (names));
  h = 1e-4;
  for k = find (size_ != 0)
    for way = [1, -1]
      [m, ~, one] = gs.proof.model_at (setfield (d, "tasks", own), struct (names{k}, 1 + way * h));
      [~, x] = gs.proof.motion_command (m, d.axes, one, one.start);
      S(:,k) += way * x(1,:)' / (2 * h * size_(k));
    endfor
  endfor
endfunction

## row k: of what was given at the sample before (those before, with a longer delay)
function V = voltages (d, r)
  c = d.controller;
  [n, nu, np] = deal (rows (r.x), numel (d.axes), size (r.slopes, 3));
  late = 1 + floor (c.delay / c.period + 1e-9);
  v = r.v(:,[d.axes.input]);
  free = v > c.limits(:,1)' * (1 - eps) & v < c.limits(:,2)' * (1 - eps);
  free = [free(1+late:end,:); true(late, nu)](1:n,:);
  Dy = c.D(:,1:nu);
  By = c.B(:,1:nu);
  V = zeros (n, nu, np);
  z = zeros (rows (c.A), np);
  for k = 1:n
    y = reshape (r.slopes(k,[d.axes.k],:), nu, np);
    raw = c.C * z + Dy * y;
    given = raw .* free(k,:)';
    if (k + late <= n)
      V(k+late,:,:) = reshape (given, 1, nu, np);
    endif
    z = c.A * z + By * y + c.G * (given - raw);
  endfor
endfunction
