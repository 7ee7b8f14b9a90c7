## runs = before_plan (m, given)
## List the runs of the model M from the values GIVEN (before_starts): a row of structs with
##
##     name      METHOD VARIANT; the variant is - or what is special: a constraint method, rest (no
##               speeds, no inputs), plan (inputs that jump), feedback, audit, sensitivity, an
##               order, undrifted (option drift false), far and unclosed (off the constraints)
##     method    of gsmbp_simulate
##     x0        the initial state
##     problem   options that say what is solved
##     solver    options that only say how

function runs = before_plan (m, given)
  most = inputs (m);
  [rest, moving, v] = starts (m, given, most);
  input = {"input", v};
  rows = {"dp853", "-", moving, input, {}
          "rk4", "-", moving, input, {}
          "radau", "-", moving, input, {}
          "radau", "order5", moving, input, {"maxorder", 5}
          "gauss", "-", moving, input, {}
          "gauss", "order4", moving, input, {"maxorder", 4}
          "cvode", "-", moving, input, {}
          "auto", "-", moving, input, {}
          "dp853", "rest", rest, {}, {}
          "radau", "rest", rest, {}, {}};
  if (any (most))
    rows = [rows; driven(m, moving, v, most)];
  end
  if (m.sizes.nlam > 0)
    rows = [rows; loops(moving, input); unclosed(m, moving, input)];
  end
  if (any (strcmp (m.subroutines, "rha")))
    rows(end+1,:) = {"dp853", "audit", moving, [input, {"audit", 1}], {}};
  end
  if (any (strcmp (m.subroutines, "rhp")))
    name = {"sensitivity", cellstr(m.json.sensitivity)(1)};
    rows = [rows; {"dp853", "sensitivity", moving, [input, name], {}
                   "radau", "sensitivity", moving, [input, name], {}}];
  end
  rows(:,1:2) = [strcat(rows(:,1), {" "}, rows(:,2)), rows(:,1)];   # name, method
  runs = cell2struct (rows, {"name", "method", "x0", "problem", "solver"}, 2)';
end

## the constraint methods
function rows = loops (moving, input)
  rows = {"radau", "index2", moving, input, {"loops", "index2"}
          "rk4", "nullspace", moving, input, {"loops", "nullspace"}
          "dp853", "undrifted", moving, input, {"drift", false}};
  for way = {"baumgarte", "partitioning", "nullspace", "svd", "kane"}
    rows(end+1,:) = {"dp853", way{1}, moving, input, [{"loops"}, way]};
  end
end

## from where the loops are not closed: the start moved onto the constraints, and refused
function rows = unclosed (m, x, input)
  q = 1:m.sizes.nq;
  x(q) += 0.3 * cos (q') .* min (1, m.nominal(q));
  rows = {"dp853", "far", x, input, {}
          "dp853", "unclosed", x, [input, {"start", "check"}], {}};
end

## inputs that jump and rise; state feedback, at MOST of the inputs, within limits
function rows = driven (m, x, v, most)
  d = m.sizes;
  levels = [0 * v, 2 * v, -v];
  slopes = [3 * v, 0 * v, v];
  jumps = mkpp ([0 0.15 0.3 0.5], [slopes(:), levels(:)], d.nv);
  gain = 0.05 * most .* cos ((1:d.nv)' + 2 * (1:d.nx)) ./ m.nominal';
  feedback = {"input", v, "gain", gain, "reference", 0.9 * x, "limits", 0.15 * max(most, 1e-9)};
  rows = {"dp853", "plan", x, {"input", jumps}, {}
          "radau", "plan", x, {"input", jumps}, {}
          "dp853", "feedback", x, feedback, {}};
end

## what is large for the inputs [SI]: strokes and openings of valves are small, modes of events
## belong to the run
function most = inputs (m)
  most = ones (m.sizes.nv, 1);
  most(strcmp (m.units.inputs, "m")) = 1e-3;
  most(strcmp (m.units.inputs, "m^2")) = 1e-7;
  if (! isempty (m.events))
    own = [m.events.input];
    most(own(own > 0)) = 0;
  end
end

## at rest; with speeds of a tenth of the nominal ones at most; inputs of several signs
function [rest, moving, v] = starts (m, given, most)
  d = m.sizes;
  v = 0.2 * most .* cos (3 * (1:d.nv)');
  u = d.nq + (1:d.nu);
  rest = m.initial;
  moving = rest;
  moving(u) += 0.1 * cos (2 * (1:d.nu)') .* min (1, m.nominal(u));
  for name = fieldnames (given)'
    rest(strcmp (m.states, name{1})) = given.(name{1});
    moving(strcmp (m.states, name{1})) = given.(name{1});
    v(strcmp (m.inputs, name{1})) = given.(name{1});
  end
end
