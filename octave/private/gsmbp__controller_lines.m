## steps = gsmbp__controller_lines (c)
## One sample of the controller C as steps {target, kind, terms}, in an order in which they can be
## carried out: what both languages write.  Kinds: "sum" (terms: factor, name), "round" (argument,
## step), "clip" (argument, lower, upper), "copy".  Names: y1.., r1.., z1.. (memory), u1..
## (outputs), e1.. (deviations), w1.. (raw outputs), d1.. (what the limits and the converter took),
## n1.. (next memory).

function steps = gsmbp__controller_lines (c)
  ny = numel (c.measured);
  nr = numel (c.references);
  nu = numel (c.driven);
  nz = rows (c.A);
  steps = cell (0, 3);
  for k = 1:ny
    from = sprintf ("y%d", k);
    if (c.step_in(k) > 0)
      steps(end+1,:) = {sprintf("e%d", k), "round", {from, c.step_in(k)}};
      from = sprintf ("e%d", k);
    endif
    steps(end+1,:) = {sprintf("e%d", k), "sum", [{1, from}; constant(-c.y0(k))]};
  endfor
  for k = 1:nr
    steps(end+1,:) = {sprintf("e%d", ny + k), "sum", ...
                      [{1, sprintf("r%d", k)}; constant(-c.r0(k))]};
  endfor
  for k = 1:nu
    steps(end+1,:) = {sprintf("w%d", k), "sum", ...
                      [constant(c.u0(k)); terms(c.C(k,:), "z"); terms(c.D(k,:), "e")]};
    u = sprintf ("u%d", k);
    steps(end+1,:) = {u, "copy", {sprintf("w%d", k)}};
    if (any (isfinite (c.limits(k,:))))
      steps(end+1,:) = {u, "clip", {u, c.limits(k,1), c.limits(k,2)}};
    endif
    if (c.step_out(k) > 0)
      steps(end+1,:) = {u, "round", {u, c.step_out(k)}};
    endif
    steps(end+1,:) = {sprintf("d%d", k), "sum", {1, u; -1, sprintf("w%d", k)}};
  endfor
  for k = 1:nz
    steps(end+1,:) = {sprintf("n%d", k), "sum", [terms(c.A(k,:), "z"); terms(c.B(k,:), "e"); ...
                                                 terms(c.G(k,:), "d")]};
  endfor
  for k = 1:nz
    steps(end+1,:) = {sprintf("z%d", k), "copy", {sprintf("n%d", k)}};
  endfor
endfunction

## factors that are not zero, with their names
function list = terms (row, letter)
  k = find (row);
  list = [num2cell(row(k)(:)), arrayfun(@(i) sprintf ("%s%d", letter, i), k(:), ...
                                        "UniformOutput", false)];
endfunction

function list = constant (x)
  list = cell (0, 2);
  if (x != 0)
    list = {x, ""};
  endif
endfunction
