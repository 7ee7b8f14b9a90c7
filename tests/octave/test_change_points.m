## Change points: the passage of positions where the constraints lose rank by dp853, ends, outputs
## and breaks in, at and beside them.

function test_change_points ()
  warning ("off", "gsmbp:singular", "local");
  rand ("twister", 14);
  for k = 1:2
    s = scene (k);
    for rtol = [1e-6, 1e-10, 1e-13]
      passages (s, rtol);
    end
    for rtol = [1e-6, 1e-13]
      beside (s, rtol);
    end
  end
end

## without gravity: a parallelogram, whose crank turns evenly, and a crank as long as its rod; each
## with lengths that have no change point, and the time of half a turn (which passes one)
function s = scene (k)
  w = 6;
  if (k == 1)
    m = gsmbp_set (gsmbp_hand ("hand_fourbar"), "g", 0, "l1", 0.3, "l3", 0.3, "l2", 0.7, "l4", 0.7);
    smooth = gsmbp_set (m, "l1", 0.6, "l2", 0.7, "l3", 0.7, "l4", 0.3);
    x0 = [0.6; 0; 0.6; w; 0; w];
    xs = gsmbp_assemble (smooth, [0.6; 0.9; 1.6; w; 0; w], "hold", "q1");
    first = (pi - 0.6) / w;
    name = "parallelogram";
  else
    m = gsmbp_set (gsmbp_hand ("hand_crank"), "g", 0, "l1", 0.3, "l2", 0.3);
    smooth = gsmbp_set (m, "l2", 0.6);
    x0 = [0.3; -0.3; 0.6*cos(0.3); w; -w; -0.6*w*sin(0.3)];
    xs = gsmbp_assemble (smooth, [0.3; -0.15; 0.8; w; 0; 0], "hold", "q1");
    first = gsmbp_simulate (m, x0, [0, 0.6], "rtol", 1e-13).stats.singular_times(1);
    name = "equal-armed slider-crank";
  end
  s = struct ("m", m, "x0", x0, "smooth", smooth, "xs", xs, "first", first, "name", name);
end

function e = energy_error (m, x)
  e = arrayfun (@(k) sum (m.ene (0, x(k,:)')(1:2)), 1:rows (x));
  e = max (abs (e - e(1))) / e(1);
end

## four passages: first steps and output grids by chance
function passages (s, rtol)
  last = s.first + 3.3 * pi / 6;
  for k = 4:-1:1
    t = [0, sort(last * rand (1, floor (40 * rand ()))), last];
    step = 0.1 * rand ();
    r = gsmbp_simulate (s.m, s.x0, t, "rtol", rtol, "step", step);
    q = gsmbp_simulate (s.smooth, s.xs, t, "rtol", rtol, "step", step);
    found(k) = energy_error (s.m, r.x);
    beside(k) = energy_error (s.smooth, q.x);
    calls(k) = r.stats.calls / q.stats.calls;
  end
  what = sprintf ("%s, rtol %.0e", s.name, rtol);
  gsmbp_check ([what ": energy"], found, max (100 * median (beside), 4e-12));
  gsmbp_check ([what ": calls beside those of a smooth motion"], calls, 3);
end

## the run ends there, has an output there, starts again there
function beside (s, rtol)
  q = gsmbp_simulate (s.smooth, s.xs, [0, s.first + 0.4], "rtol", rtol);
  limit = max (100 * energy_error (s.smooth, q.x), 2e-12);
  calls = 3 * q.stats.calls;
  for d = [-1e-2, -1e-5, -1e-7, 0, 1e-9, 1e-7, 1e-4]
    t = s.first + d;
    r = gsmbp_simulate (s.m, s.x0, [0, t], "rtol", rtol);
    q = gsmbp_simulate (s.m, s.x0, [0, t, t + 0.4], "rtol", rtol);
    b = gsmbp_simulate (s.m, s.x0, [0, t + 0.4], "rtol", rtol, "breaks", t);
    what = sprintf ("%s, rtol %.0e, %g s beside the point", s.name, rtol, d);
    gsmbp_check ([what ": energy at an end, an output, behind a break"],
                 [energy_error(s.m, r.x), energy_error(s.m, q.x), energy_error(s.m, b.x)], limit);
    gsmbp_check ([what ": calls"], [r.stats.calls, q.stats.calls, b.stats.calls] <= calls);
  end
end
