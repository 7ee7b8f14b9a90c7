## Splines in space: points and rotations met, lengths by another quadrature, the speed along them,
## rates against differences, turns about one axis against splines of numbers, two points as a line.

function test_path_spline ()
  rand ("seed", 4);
  randn ("seed", 4);
  points = randn (3, 6);
  R = zeros (3, 3, 6);
  for k = 1:6
    R(:,:,k) = expm (cross_of (randn (3, 1)));
  end
  o = {"speed", 0.4, "acceleration", 2, "jerk", 20};
  path = gsmbp_path ("spline", points, o{:}, "rotations", R);
  knots (path, points, R);
  lengths (path);
  lengths (gsmbp_path ("spline", [0 1 0 -1; 0 0 1e-4 1; 0 0 0 1e-3], o{:}));
  rates (path);
  continuous (path);
  about_one_axis (points, o);
  two_points (points(:,1:2), R(:,:,1:2), o);
  refused (points);
end

function K = cross_of (r)
  K = [0, -r(3), r(2); r(3), 0, -r(1); -r(2), r(1), 0];
end

## times when the way is that of the knots
function t = times_of (path)
  [~, at] = min (abs (path.arc(1,:)' - path.knots));
  t = arrayfun (@(s) fzero (@(t) gsmbp_evaluate (path.s, t) - s, path.times, ...
                            optimset ("TolX", 1e-15)), path.arc(2,at(2:end-1)));
  t = [path.times(1), t, path.times(2)];
end

function knots (path, points, R)
  f = gsmbp_along (path, times_of (path));
  gsmbp_check ("spline: its points", f.p - points, 1e-12);
  gsmbp_check ("spline: its rotations", f.R - R, 1e-11);
  gsmbp_check ("spline: at rest at both ends", [f.v(:,[1, end]), f.omega(:,[1, end])], 1e-15);
end

function lengths (path)
  rate = @(x) norm (gsmbp_evaluate (path.curve, x, 1)(:,:,2));
  total = 0;
  for k = 1:numel (path.knots) - 1
    total += quadgk (@(x) arrayfun (rate, x), path.knots(k), path.knots(k+1), "AbsTol", 1e-13);
  end
  gsmbp_check ("spline: length by another quadrature", path.length / total - 1, 1e-11);
  t = linspace (path.times(1), path.times(2), 50);
  f = gsmbp_along (path, t);
  gsmbp_check ("spline: speed along it", norm (f.v, "columns") - f.s(2,:), 1e-14);
end

function rates (path)
  t = path.times(1) + diff (path.times) * rand (1, 20);
  h = 1e-5;
  [f, b, a] = deal (gsmbp_along (path, t), gsmbp_along (path, t - h), gsmbp_along (path, t + h));
  gsmbp_check ("spline: v by differences", (a.p - b.p) / (2*h) - f.v, 1e-8);
  gsmbp_check ("spline: a by differences", (a.v - b.v) / (2*h) - f.a, 1e-7);
  gsmbp_check ("spline: alpha by differences", (a.omega - b.omega) / (2*h) - f.alpha, 1e-6);
  worst = 0;
  for k = 1:numel (t)
    S = (a.R(:,:,k) - b.R(:,:,k)) / (2*h) * f.R(:,:,k)';
    worst = max ([worst; abs([S(3,2); S(1,3); S(2,1)] - f.omega(:,k)); ...
                  abs(f.R(:,:,k)' * f.R(:,:,k) - eye (3))(:)]);
  end
  gsmbp_check ("spline: omega by differences", worst, 1e-7);
end

function continuous (path)
  t = times_of (path)(2:end-1);
  [b, a] = deal (gsmbp_along (path, t - 1e-9), gsmbp_along (path, t + 1e-9));
  gsmbp_check ("spline: acceleration without a jump", a.a - b.a, 1e-6);
  gsmbp_check ("spline: angular acceleration without a jump", a.alpha - b.alpha, 1e-6);
end

## angles about one axis are a spline of numbers
function about_one_axis (points, o)
  angles = [0.3, 1.2, -0.4, 0.2, 2, 1.1];
  axis = [1; 2; -2] / 3;
  R = zeros (3, 3, 6);
  for k = 1:6
    R(:,:,k) = expm (angles(k) * cross_of (axis));
  end
  path = gsmbp_path ("spline", points, o{:}, "rotations", R);
  plan = gsmbp_plan ("cubic", angles, path.knots);
  rate = @(x) norm (gsmbp_evaluate (path.curve, x, 1)(:,:,2));
  worst = way = 0;
  x = sort ([0, path.knots(end) * rand(1, 12)]);
  for k = 2:numel (x)
    inside = path.knots(path.knots > x(k-1) & path.knots < x(k));
    way += quadgk (@(x) arrayfun (rate, x), x(k-1), x(k), "AbsTol", 1e-13, "WayPoints", inside);
    t = fzero (@(t) gsmbp_evaluate (path.s, t) - way, path.times, optimset ("TolX", 1e-15));
    wanted = expm (gsmbp_evaluate (plan, x(k)) * cross_of (axis));
    worst = max (worst, max (max (abs (gsmbp_along (path, t).R - wanted))));
  end
  gsmbp_check ("spline: turns about one axis are a spline of angles", worst, 1e-10);
end

function two_points (points, R, o)
  a = gsmbp_path ("spline", points, o{:}, "rotations", R);
  b = gsmbp_path ("line", points, o{:}, "rotations", R);
  t = linspace (b.times(1), b.times(2), 20);
  [f, g] = deal (gsmbp_along (a, t), gsmbp_along (b, t));
  worst = 0;
  for field = {"p", "v", "a", "R", "omega", "alpha"}
    worst = max (worst, max (abs (f.(field{1})(:) - g.(field{1})(:))));
  end
  gsmbp_check ("spline through two points: a line", worst, 1e-12);
end

function refused (points)
  said = gsmbp_complaint (@() gsmbp_path ("spline", points(:,[1, 2, 2, 3]), "speed", 1, ...
                                          "acceleration", 1));
  gsmbp_check (["refused: " said], ! isempty (strfind (said, "points 2 and 3 of the spline")));
  said = gsmbp_complaint (@() gsmbp_path ("spline", points, "speed", 1, "acceleration", 1, ...
                                          "rotations", zeros (3, 3, 2)));
  gsmbp_check (["refused: " said], ! isempty (strfind (said, "expected 3 x 3 x 6, found 3x3x2")));
  for row = {[0 1 0; 0 0 0; 0 0 0], "points 2 and 3: its tangent vanishes at [1, 0, 0]"
             [0 1 0 1; 2 2 2 2; 0 1 0 1], "points 1 and 2: its tangent vanishes at [1.01"
             [0 1e-3 0.5e-3 1; zeros(2, 4)], "points 1 and 2: its tangent vanishes at ["}'
    said = gsmbp_complaint (@() gsmbp_path ("spline", row{1}, "speed", 1, "acceleration", 1));
    gsmbp_check (["refused: " said], ! isempty (strfind (said, row{2})));
  end
end
