## Planners against reference values of 30 digits: trapezoids, double S, splines, lines and circles
## in space. Error: largest difference of an array over its largest entry.

function test_reference_planners ()
  profiles ("r4_trapezoid", "trapezoid", 1);
  profiles ("r4_double_s", "double_s", 2);
  s = read ("r4_space");
  for i = 1:numel (s.spec.paths)
    in_space (s.spec.paths{i}, s.reference.paths{i});
  end
  worst = 0;
  for i = 1:numel (s.spec.splines)
    worst = max (worst, spline_error (s.spec.splines{i}, s.reference.splines{i}));
  end
  gsmbp_check ("splines: knots and samples", worst, 1e-13);
end

function s = read (name)
  folder = fullfile (fileparts (mfilename ("fullpath")), "..", "data", name);
  for part = {"spec", "reference"}
    s.(part{1}) = in_cells (jsondecode (fileread (fullfile (folder, [part{1} ".json"]))));
  end
end

## lists of structs as cell arrays
function s = in_cells (s)
  for field = fieldnames (s)'
    if (isstruct (s.(field{1})) && numel (s.(field{1})) > 1)
      s.(field{1}) = num2cell (s.(field{1}));
    end
  end
end

function x = number (s)
  x = str2double (strrep (s, "pi", num2str (pi, 17)));
end

function e = relative (a, b)
  e = max (abs (a(:) - b(:))) / max (max (abs (b(:))), 1e-300);
end

function profiles (folder, kind, nd)
  s = read (folder);
  warning ("off", "gsmbp:plan", "local");
  worst = [0 0];
  for i = 1:numel (s.spec.cases)
    [c, r] = deal (s.spec.cases{i}, s.reference.cases{i});
    o = {"speed", number(c.V), "acceleration", number(c.A), "start", number(c.v0), ...
         "end", number(c.v1)};
    if (isfield (c, "J"))
      o = [o, {"jerk", number(c.J)}];
    end
    [plan, law] = gsmbp_plan (kind, [0 number(c.h)], o{:});
    found = {law.T, law.durations, law.switch_q, law.switch_v};
    wanted = {number(r.T), number(r.durations), number(r.switch_q), number(r.switch_v)};
    worst(1) = max ([worst(1), cellfun(@relative, found, wanted)]);
    samples = r.samples(:);
    f = reshape (gsmbp_evaluate (plan, number ({samples.t}), nd), numel (samples), nd + 1);
    names = {"q", "v", "a"};
    for k = 1:nd+1
      worst(2) = max (worst(2), relative (f(:,k), number ({samples.(names{k})})));
    end
  end
  gsmbp_check (sprintf ("%s, %d cases: times, phases, switches; samples", kind, i), worst, 1e-13);
end

function in_space (c, r)
  points = cell2mat (cellfun (@(p) number (p(:)), c.points(:)', "UniformOutput", false));
  kind = {"line", "circle"}{columns(points) - 1};
  o = {"speed", number(c.V), "acceleration", number(c.A), "rotations", ...
       cat(3, turned (c.rpy0), turned (c.rpy1))};
  if (! isempty (c.J))
    o = [o, {"jerk", number(c.J)}];
  end
  if (isfield (r, "error") && ! isempty (r.error))
    try
      gsmbp_path (kind, points, o{:});
      gsmbp_check ([c.name ": refused"], false);
    catch problem
      gsmbp_check ([c.name ": refused"], ! isempty (strfind (problem.message, "collinear")));
    end
    return;
  end
  path = gsmbp_path (kind, points, o{:});
  worst = relative ([path.length, path.angle, path.times(2)], ...
                    [number(r.length), number(r.angle), number(r.T)]);
  for k = 1:numel (r.samples)
    z = r.samples(k);
    f = gsmbp_along (path, number (z.t));
    R = cell2mat (cellfun (@(row) number (row(:))', rows_of (z.R), "UniformOutput", false));
    worst = max ([worst, norm(f.p - number (z.p)), norm(f.v - number (z.v)), ...
                  norm(f.a - number (z.acc)), norm(f.R - R), norm(f.omega - number (z.omega))]);
  end
  gsmbp_check (sprintf ("%s: %d poses with their rates", c.name, k), worst, 1e-13);
end

function c = rows_of (c)
  c = c(:);
  if (! iscell (c{1}))
    c = num2cell (reshape (c, 3, 3), 2);
  end
end

function R = turned (rpy)
  a = number (rpy);
  about = @(e, t) expm (t * [0, -e(3), e(2); e(3), 0, -e(1); -e(2), e(1), 0]);
  R = about ([0 0 1], a(3)) * about ([0 1 0], a(2)) * about ([1 0 0], a(1));
end

function e = spline_error (c, r)
  o = {};
  if (! isempty (c.end_speeds))
    o = {"start", number(c.end_speeds{1}), "end", number(c.end_speeds{2})};
  end
  t = number (c.t)';
  plan = gsmbp_plan ("cubic", number (c.q)', t, o{:});
  f = reshape (gsmbp_evaluate (plan, t, 2), numel (t), 3);
  samples = r.samples(:);
  e = max ([relative(f(:,2), number (r.knot_speed)), relative(f(:,3), number (r.knot_acc)), ...
            relative(gsmbp_evaluate (plan, number ({samples.t}))', number ({samples.q})')]);
end
