## steps = gs.controller.step_lines (c)
## One sample of the controller C as steps {target, kind, terms}, in an order in which they can be
## carried out: what both languages write.  Kinds: "sum" (terms: factor, name), "round" (argument,
## step), "clip" (argument, lower, upper), "copy".  Names: y1.., r1.., z1.. (memory), u1..
## (outputs), e1.. (deviations), w1.. (raw outputs), d1.. (what the limits and the converter took),
## n1.. (next memory).  A schedule (gsmbp_schedule) has further kinds: "when", "else", "end" about
## what is between two of its points, "weight" (S, from 0 to 1 between them), "keep" (p1.. of w1..,
## m1.. of n1..), "blend" (of two, by S), "gain" (two factors, name).

function steps = step_lines (c)
  nz = rows (c.A);
  if (isfield (c, "schedule"))
    steps = scheduled (c);
  else
    steps = [law(c); given(c)];
    for k = 1:nz
      steps(end+1,:) = {sprintf("n%d", k), "add", terms(c.G(k,:), "d")};
    endfor
  endif
  for k = 1:nz
    steps(end+1,:) = {sprintf("z%d", k), "copy", {sprintf("n%d", k)}};
  endfor
endfunction

## deviations, raw outputs, next memory but for what limits take
function steps = law (c)
  ny = numel (c.measured);
  steps = cell (0, 3);
  for k = 1:ny
    from = sprintf ("y%d", k);
    if (c.step_in(k) > 0)
      steps(end+1,:) = {sprintf("e%d", k), "round", {from, c.step_in(k)}};
      from = sprintf ("e%d", k);
    endif
    steps(end+1,:) = {sprintf("e%d", k), "sum", [{1, from}; constant(-c.y0(k))]};
  endfor
  for k = 1:numel (c.references)
    steps(end+1,:) = {sprintf("e%d", ny + k), "sum", ...
                      [{1, sprintf("r%d", k)}; constant(-c.r0(k))]};
  endfor
  for k = 1:numel (c.driven)
    steps(end+1,:) = {sprintf("w%d", k), "sum", ...
                      [constant(c.u0(k)); terms(c.C(k,:), "z"); terms(c.D(k,:), "e")]};
  endfor
  for k = 1:rows (c.A)
    steps(end+1,:) = {sprintf("n%d", k), "sum", [terms(c.A(k,:), "z"); terms(c.B(k,:), "e")]};
  endfor
endfunction

## outputs within their limits
function steps = given (c)
  steps = cell (0, 3);
  for k = 1:numel (c.driven)
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
endfunction

## between two points of a schedule both laws, blended
function steps = scheduled (c)
  [v, laws] = deal (c.schedule.values, c.schedule.laws);
  y = sprintf ("y%d", c.schedule.signal);
  [nu, nz] = deal (numel (c.driven), rows (c.A));
  n = numel (v) - 1;
  steps = cell (0, 3);
  for i = 1:n
    if (n > 1 && i < n)
      steps(end+1,:) = {y, "when", {v(i+1), i > 1}};
    elseif (n > 1)
      steps(end+1,:) = {y, "else", {}};
    endif
    steps(end+1,:) = {y, "weight", {v(i), v(i+1)}};
    steps = [steps; law(laws{i}); named("keep", "p", "w", nu); named("keep", "m", "n", nz); ...
             law(laws{i+1}); named("blend", "w", "p", nu); named("blend", "n", "m", nz)];
    steps = [steps; given(c)];
    for k = 1:nz
      for j = find (laws{i}.G(k,:) | laws{i+1}.G(k,:))
        steps(end+1,:) = {sprintf("n%d", k), "gain", {laws{i}.G(k,j), laws{i+1}.G(k,j), ...
                                                      sprintf("d%d", j)}};
      endfor
    endfor
  endfor
  if (n > 1)
    steps(end+1,:) = {y, "end", {}};
  endif
endfunction

function steps = named (kind, to, from, n)
  steps = cell (n, 3);
  for k = 1:n
    steps(k,:) = {sprintf("%s%d", to, k), kind, {sprintf("%s%d", from, k)}};
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
