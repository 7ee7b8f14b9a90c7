## d = gs.machine.add_springs (m, d)
## The model of the design D: M, its springs chosen so that the mean square of what holds the axes
## still along the tasks is least; d.springs, the decision (empty: no springs are free).

function d = add_springs (m, d)
  d.model = m;
  d.springs = struct ("what", {}, "chosen", {}, "why", {}, "alternatives", {});
  list = d.asked.springs;
  if (isempty (list))
    return;
  endif
  free = cell (rows (list), 3);
  for k = 1:rows (list)
    start = min (max (m.par.(list{k,1}), list{k,2}(1)), list{k,2}(2));
    free(k,:) = {list{k,1}, start, list{k,2}};
  endfor
  goal = cellfun (@(name) {"square", ["effort." name], 1}, {d.axes.coordinate}, "UniformOutput", ...
                  false);
  r = gsmbp_optimize (m, free, vertcat (goal{:}), {}, ...
                      {"positions", {d.axes.coordinate}, positions(d), "guess", ...
                       m.initial(1:m.sizes.nq)'});
  said = strjoin (cellfun (@(name) sprintf ("%s = %.5g %s", name, r.values.(name), ...
                                            unit_of (m, name)), list(:,1)', "UniformOutput", ...
                           false), ", ");
  law = sprintf (["what holds the axes still along the motions, the sum of its mean squares, " ...
                  "is least with %s: %.4g (N*m)^2; as the scene has it %.4g"], said, r.J, ...
                 square_of (m, d));
  [with, without] = deal (figures (gsmbp_set (m, r.values), d), figures (m, d));
  better = sprintf ("the best drives by %s: %s with these springs, %s as the scene has them", ...
                    strrep (d.asked.goal, "_", " "), numbers (with), numbers (without));
  if (sum (with) < sum (without))
    d.model = gsmbp_set (m, r.values);
    d.springs(1) = struct ("what", "Springs", "chosen", said, "why", {{law, better}}, ...
                           "alternatives", {{}});
  else
    d.springs(1) = struct ("what", "Springs", "chosen", "as the scene has them", "why", ...
                           {{better}}, "alternatives", {{law}});
  endif
endfunction

## places along the tasks, a row each
function q = positions (d)
  q = zeros (0, numel (d.axes));
  for one = d.tasks
    f = gsmbp_evaluate (one.plan, linspace (one.start, one.stop, 21));
    q = [q; reshape(f, numel (d.axes), 21)'];
  endfor
endfunction

function J = square_of (m, d)
  J = 0;
  q = positions (d);
  x = m.initial(1:m.sizes.nq);
  for k = 1:rows (q)
    x([d.axes.k]) = q(k,:);
    if (m.sizes.nlam > 0)
      x = gsmbp_assemble (m, x, "hold", {d.axes.coordinate})(1:m.sizes.nq);
    endif
    J += sum (held (m, x, d) .^ 2) / rows (q);
  endfor
endfunction

function tau = held (m, q, d)
  zero = zeros (m.sizes.nu, 1);
  if (m.sizes.nlam > 0)
    tau = m.inl (0, q, zero, zero);
    tau = tau([d.axes.column]);
  else
    tau = m.inv (0, q, zero, zero);
    tau = tau([d.axes.k]);
  endif
endfunction

function text = unit_of (m, name)
  text = m.units.parameters{strcmp (fieldnames (m.par), name)};
endfunction

## the best drives by the goal, one number an axis; infinite where there is none
function x = figures (m, d)
  cycles = gs.drive.load_cycles (m, d.axes, d.tasks);
  x = arrayfun (@(t) best_of (t, d.asked.goal), gs.drive.choose_drives (d.asked, cycles));
endfunction

function x = best_of (t, goal)
  x = Inf;
  if (! isempty (t.order))
    x = t.pairs(t.order(1)).(goal);
  endif
endfunction

function text = numbers (x)
  text = strjoin (arrayfun (@(v) sprintf ("%.4g", v), x, "UniformOutput", false), ", ");
  text = strrep (text, "Inf", "none");
endfunction
