## Positions where the constraints lose rank: ten passages of them, a sample of
## `make bench-passages`; starts in them; friction, a stop and samples by them.

function test_passages ()
  warning ("off", "gsmbp:singular", "local");
  addpath (fullfile (fileparts (fileparts (mfilename ("fullpath"))), "bench", "passages"));
  ten_passages ();
  seen_from_afar ();
  starts ();
  refused ();
  stepped_over ();
  jump_of_the_input ();
  events ();
  stop_in_the_position ();
end

function ten_passages ()
  scenes = {passage_scene("parallelogram", gsmbp_hand ("hand_fourbar")), ...
            passage_scene("parallelograms", gsmbp_fixture ("parallelograms3")), ...
            passage_scene("slider-crank", gsmbp_hand ("hand_crank"))};
  pairs = [7, 31, 12, 40, 3; 5, 22, 38, 9, 16]';
  for k = 1:numel (scenes)
    s = scenes{k};
    for rtol = 10 .^ -(6:13)
      r = passage_measure (s, rtol, pairs, 3);
      what = sprintf ("%s, %s, rtol %.0e", s.name, s.m.name, rtol);
      gsmbp_check ([what ": every run ends"], isempty (r.failed));
      gsmbp_check ([what ": energy"], r.energy, r.limit);
      gsmbp_check ([what ": calls beside those of a smooth motion"], r.calls, 3);
      gsmbp_check ([what ": ten positions or more are reported"], r.found >= 10);
    end
  end
end

## a first step of the passage that begins 1.5 rad before the position, as an output time wants it
function seen_from_afar ()
  s = passage_scene ("slider-crank", gsmbp_hand ("hand_crank"));
  lost = found = [];
  for first = [0.0925:1e-4:0.093, 0.1031:1e-4:0.1037, 0.1094]
    r = gsmbp_simulate (s.m, s.x0, [0, first, 0.6], "rtol", 1e-13);
    lost(end+1) = energy (s.m, r.x(3,:)) / energy (s.m, s.x0) - 1;
    found(end+1) = r.stats.singular_positions;
  end
  gsmbp_check ("slider-crank, a position seen from afar: energy", lost, 1e-12);
  gsmbp_check ("slider-crank, a position seen from afar: reported", found - 1, 0);
end

## the state of S beside its position by OFF radians of the crank, behind it for OFF > 0
function x = beside (s, off)
  x = s.x0;
  nq = s.m.sizes.nq;
  w = x(nq+1);
  if (strcmp (s.name, "slider-crank"))
    q = pi/2 + off;
    x = [q; -q; 0.6*cos(q); w; -w; -0.6*w*sin(q)];
  else
    x(1:nq) += (pi + off - x(1)) * x(nq+1:end) / w;
  end
end

function e = energy (m, x)
  e = sum (m.ene (0, x(:))(1:2));
end

## in the position, and beside it, by all ways that look for it
function starts ()
  bar = passage_scene ("parallelogram", gsmbp_hand ("hand_fourbar"));
  row = passage_scene ("parallelograms", gsmbp_fixture ("parallelograms3"));
  crank = passage_scene ("slider-crank", gsmbp_hand ("hand_crank"));
  for s = {bar, row, crank}
    ways = {"projection", "partitioning", "nullspace", "svd", "kane"};
    if (strcmp (s{1}.name, "slider-crank"))
      ways = ways(1:2);
    end
    for way = ways
      lost = apart = [];
      for off = [0, 1e-12, 1e-9, 1e-6, -1e-9, -1e-6, -1e-3, 1e-3]
        x0 = beside (s{1}, off);
        r = gsmbp_simulate (s{1}.m, x0, [0, 0.1, 0.3], "loops", way{1}, "rtol", 1e-12);
        lost(end+1) = energy (s{1}.m, r.x(3,:)) / energy (s{1}.m, x0) - 1;
        moved = r.x(3,1:2) - r.x(1,1:2);
        nq = s{1}.m.sizes.nq;
        apart(end+1) = moved(2) - moved(1) * x0(nq+2) / x0(nq+1);
      end
      what = sprintf ("%s, %s, starts in and beside the position", s{1}.m.name, way{1});
      gsmbp_check ([what ": energy"], lost, 2e-12);
      gsmbp_check ([what ": the branch of the speeds"], apart, 1e-10);
    end
  end
end

function says (f, text)
  found = gsmbp_complaint (f);
  if (! gsmbp_check (["message: " text], ! isempty (strfind (found, text))))
    printf ("  found: %s\n", found);
  end
end

## at rest, by other methods, with speeds that lie between the branches: one error
function refused ()
  s = passage_scene ("parallelogram", gsmbp_hand ("hand_fourbar"));
  m = s.m;
  x = beside (s, 0);
  lost = @(why) ["at t = 0 s they lose rank: " why ...
                 "; start beside that position; found in rows C.x"];
  for method = {"rk4", "cvode"}
    says (@() gsmbp_simulate (m, x, [0 1], "method", method{1}), ...
          lost ("only method \"dp853\" begins there"));
    says (@() gsmbp_simulate (m, beside (s, 1e-7), [0 1], "method", method{1}), ...
          lost ("only method \"dp853\" begins there"));
    r = gsmbp_simulate (m, beside (s, 1e-2), [0 0.3], "method", method{1});
    gsmbp_check ([method{1} " begins 0.01 rad beside"], ...
                 energy (m, r.x(2,:)) / energy (m, x) - 1, 1e-9);
  end
  rest = [x(1:3); 0; 0; 0];
  for method = {"dp853", "rk4", "cvode"}
    says (@() gsmbp_simulate (gsmbp_set (m, "g", 9.81), rest, [0 1], "method", method{1}), ...
          lost ("at rest it may go on in more than one way"));
  end
  r = gsmbp_simulate (m, rest, [0 1]);
  gsmbp_check ("without forces it stays at rest", r.x(2,:) - rest', 0);
  [~, ~, H] = m.con (0, x(1:3), x(4:6));
  N = null (H);
  u = N * (N' * [6; 2; 5]);   # fits the rates of the constraints, but no branch
  says (@() gsmbp_simulate (m, [x(1:3); u], [0 1]), ...
        lost ("no motion with these speeds was found that leaves it"));
end

## rk4 and cvode report the position whatever their steps: long ones pass it within one of them
function stepped_over ()
  warning ("on", "gsmbp:singular", "local");
  bar = passage_scene ("parallelogram", gsmbp_hand ("hand_fourbar"));
  row = passage_scene ("parallelograms", gsmbp_fixture ("parallelograms3"));
  crank = passage_scene ("slider-crank", gsmbp_hand ("hand_crank"));
  when = [(pi - 1) / 6, (pi - 1) / 6, 0.374504];
  runs = [repmat({"rk4", "step"}, 5, 1), num2cell([1e-3; 3e-3; 0.01; 0.03; 0.1])
          repmat({"cvode", "rtol"}, 5, 1), num2cell(10 .^ -[4; 5; 6; 8; 10])]';
  seen = told = [];
  apart = -Inf;
  for k = 1:3
    s = {bar, row, crank}{k};
    for run = runs
      lastwarn ("");
      evalc ('r = gsmbp_simulate (s.m, s.x0, [0, 0.6], "method", run{:});');
      seen(end+1) = r.stats.singular_positions;
      apart = max (apart, abs (r.stats.singular_times(1) - when(k)));
      text = ["than one way there, and " run{1} ", unlike dp853, does not watch its accuracy"];
      told(end+1) = ! isempty (strfind (lastwarn (), text));
    end
  end
  gsmbp_check ("rk4 and cvode report the position that they step over", seen - 1, 0);
  gsmbp_check ("rk4 and cvode: when, in seconds", apart, 2e-3);
  gsmbp_check ("rk4 and cvode: a warning says so", told - 1, 0);
  for run = {"rk4", "cvode"; "step", "rtol"; 1e-3, 1e-9}
    for off = [0, -1e-12, 1e-9, -1e-6, 1e-4]
      at = when(1) + off;
      lastwarn ("");
      evalc ('gsmbp_simulate (bar.m, bar.x0, [0, at], "method", run{:});');
      text = sprintf ("lose rank at t = %.6g s: %s, unlike dp853", at, run{1});
      if (! isempty (strfind (lastwarn (), "passed 1 position")))
        text = "unlike dp853, does not watch its accuracy there";
      end
      what = sprintf ("%s ends %g s beside the position: a warning", run{1}, off);
      gsmbp_check (what, ! isempty (strfind (lastwarn (), text)));
    end
  end
  r = gsmbp_simulate (bar.smooth, bar.xs, [0, 2], "method", "cvode");
  gsmbp_check ("none is reported where there is none", r.stats.singular_positions, 0);
end

## a torque that jumps in, at and beside the position, against small steps of rk4: pieces that are
## constant, linear and cubic
function jump_of_the_input ()
  s = passage_scene ("parallelogram", gsmbp_hand ("hand_fourbar"));
  first = (pi - 1) / 6;
  for pieces = {[0.2; -0.3], [1.5, 0.2; -2, -0.3], [0, 5, -3, 0.2; -40, 4, 6, -0.3]}
    worst = [];
    for d = [-0.1, -0.01, 0, 1e-7, 1e-3, 0.03, 0.15, 0.18, 0.2, 0.25]
      at = first + d;
      torque = mkpp ([0, at, 1], pieces{1}, 1);
      t = [0, first / 2, at, 0.7];
      wanted = gsmbp_simulate (s.m, s.x0, t, "input", torque, "method", "rk4", "step", 3e-4);
      for rtol = [1e-6, 1e-9, 1e-12]
        r = gsmbp_simulate (s.m, s.x0, t, "input", torque, "rtol", rtol);
        away = max (abs (r.x - wanted.x)(:)) / max (abs (wanted.x)(:));
        worst(end+1) = away / max (rtol, 1e-12);
      end
    end
    order = columns (pieces{1});
    what = sprintf ("a jump of the torque by the position, pieces of order %d", order);
    gsmbp_check ([what ", beside the tolerance"], worst, 3);
  end
end

## the crank of passage_events slows down evenly, sticks; or hits its stop and turns back
function events ()
  m = gsmbp_set (gsmbp_fixture ("passage_events"), "fc", 0.2);
  sign_ = 2 * strncmp (m.coordinates, "q", 1)(:) - 1;
  w = 6;
  x0 = [sign_; w * sign_];
  a = m.par.fc * w ^ 2 / (2 * energy (m, x0));
  when = @(q) (w - sqrt (w ^ 2 - 2 * a * (q - 1))) / a;
  for rtol = [1e-6, 1e-12]
    t = [0, when(pi) + [0, 1e-9, 0.01], 2, 5];
    r = gsmbp_simulate (m, x0, t, "rtol", rtol);
    e = min (t, w / a)';
    what = sprintf ("friction and samples through three positions, rtol %.0e", rtol);
    gsmbp_check (what, r.x(:,1) - (1 + w * e - a * e .^ 2 / 2), 1e-11);
    seen = [r.stats.singular_positions, r.stats.events];
    gsmbp_check ([what ": positions, events"], seen - [3, 1], 0);
    gsmbp_check ([what ": it stays a parallelogram"], (r.x(:,1) - r.x(:,2)), 1e-12);
    for beyond = [-0.3, -0.05, -1e-3, 1e-3, 0.05, 2*pi + 0.1]
      hit = when (pi + beyond);
      t = [0, 0.2, hit + [0, 0.1, 0.6]];
      r = gsmbp_simulate (gsmbp_set (m, "hi", pi + beyond), x0, t, "rtol", rtol);
      s = t - hit;
      e = pi + beyond - 0.7 * (w - a * hit) * s + a / 2 * s .^ 2;
      e(s < 0) = (1 + w * t - a / 2 * t .^ 2)(s < 0);
      what = sprintf ("a stop %g rad behind the position, rtol %.0e", beyond, rtol);
      gsmbp_check (what, r.x(:,1) - e', 1e-10);
    end
  end
end

function stop_in_the_position ()
  m = gsmbp_set (gsmbp_fixture ("passage_events"), "fc", 0.2, "hi", pi);
  sign_ = 2 * strncmp (m.coordinates, "q", 1)(:) - 1;
  said = gsmbp_complaint (@() gsmbp_simulate (m, [sign_; 6 * sign_], [0, 1]));
  # rounding decides whether the step to it or the impact in it fails
  gsmbp_check (["a stop in the position is refused: " said], ...
               ! isempty (regexp (said, ["where the constraints lose rank: no motion with the " ...
                                         "speeds that it leaves|no position that closes the loops"],
                                  "once")));
end
