## The start of a calculation: a state off its constraints is an error that names the rows, in each
## way of the loops alike, or is moved onto them where that is asked for; below 1e-6 it is moved by
## as much as the statistics say, to one state for all ways. Rows on positions and on speeds, driven
## rows, lengths of Euler parameters; lengths in millimetres as in metres.

function test_start ()
  for name = {"four_bar", "driven_fourbar", "rolling_disc", "free_crank", "speeds_body", ...
              "close_spherical"}
    m = model (name{1});
    each_way (m);
  end
  scaled ();
  singular ();
  lost_rank ();
  others ();
  held_parameter ();
end

function m = model (name)
  if (strcmp (name, "four_bar"))
    m = gsmbp_hand ("hand_fourbar");
  else
    m = gsmbp_fixture (name);
  end
end

function list = ways (m)
  list = {"projection"};
  if (m.sizes.nlam > 0)
    list = {"baumgarte", "projection", "partitioning", "kane"};
    if (isfield (m.par, "loop_method"))
      list = [list, {"nullspace", "svd"}];
    end
  end
end

## a closed state at the time 0.3 s with speeds that fit
function x = closed (m)
  x = m.initial;
  x(m.sizes.nq + (1:m.sizes.nu)) = 0.3 * cos (1:m.sizes.nu);
  x = gsmbp_assemble (m, x, "time", 0.3);
end

function each_way (m)
  t = [0.3, 0.31];
  good = closed (m);
  r = gsmbp_simulate (m, good, t);
  gsmbp_check ([m.name ": a closed start is left as it is"], ...
               norm (r.x(1,:)' - good, Inf) <= 1e-14 && r.stats.start.moved <= 1e-14 ...
                 && r.stats.start.residual <= 1e-13);
  d = m.sizes;
  for k = 1:d.nq + d.nu
    bad = good;
    bad(k) += 0.01;
    [names, off] = rows_off (m, 0.3, bad);
    slight = good + 1e-9 * (good - bad) / 0.01;
    first = [];
    for w = ways (m)
      found = gsmbp_complaint (@() gsmbp_simulate (m, bad, t, "loops", w{1}));
      there = cellfun (@(n) ! isempty (strfind (found, [n " = "])), names);
      ## six are shown
      named = isempty (found) == isempty (names) && sum (there) == min (numel (names), 6);
      moved = gsmbp_simulate (m, bad, t, "loops", w{1}, "start", "project");
      [~, left] = rows_off (m, 0.3, moved.x(1,:)');
      small = gsmbp_simulate (m, slight, t, "loops", w{1});
      if (isempty (first))
        first = [moved.x(1,:), small.x(1,:)];
      end
      same = norm (first - [moved.x(1,:), small.x(1,:)], Inf);
      told = small.stats.start.moved - max (abs (small.x(1,:)' - slight) ./ m.nominal);
      passed = named && left <= 1e-10 && same <= 1e-12 && abs (told) <= 1e-14 ...
          && small.stats.start.moved <= 1e-7 && norm (moved.x(1,:)' - bad, Inf) < 1;
      if (! passed)
        printf ("%s %s %d: named %d left %g same %g told %g; %s | expected %s\n", m.name, w{1}, ...
                k, named, left, same, told, found, strjoin (names, ", "));
      end
      ok(k, find (strcmp (w{1}, ways (m)))) = passed;
    end
  end
  gsmbp_check (sprintf (["%s: %d states off, %d ways: an error that names the rows, one state " ...
                         "where " ...
                         "it is moved, and by how much"], m.name, rows (ok), columns (ok)), ok);
end

## the rows that are off, by their names, formed here by CON and the lengths
function [names, largest] = rows_off (m, t, x)
  d = m.sizes;
  names = {};
  largest = 0;
  for set = m.orientation'
    largest = max (largest, abs (norm (x(set)) - 1));
    if (abs (norm (x(set)) - 1) > 2e-6)
      names{end+1} = sprintf ("length of (%s) - 1", strjoin (m.coordinates(set)', ", "));
    end
    x(set) /= norm (x(set));
  end
  if (d.nlam == 0)
    return;
  end
  [phi, phit, H] = m.con (t, x(1:d.nq), x(d.nq + (1:d.nu)));
  rate = H * x(d.nq + (1:d.nu)) + phit;
  phi(m.speed_rows) = 0;
  for k = 1:d.nlam
    size_ = max (norm (H(k,:)), 1e-3);
    if (abs (phi(k)) > 2e-6 * size_)
      names{end+1} = m.multipliers{k};
    end
    if (abs (rate(k)) > 2e-6 * max ([size_, abs(H(k,:)) * abs(x(d.nq + (1:d.nu))), abs(phit(k))]))
      names{end+1} = ["rate of " m.multipliers{k}];
    end
  end
  largest = max ([largest; abs(phi); abs(rate)]);
end


function says (f, text)
  found = gsmbp_complaint (f);
  if (! gsmbp_check (sprintf ("message: %s", text), ! isempty (strfind (found, text))))
    printf ("  found: %s\n", found);
  end
end

## a crank of millimetres: the same angle is off by as much
function scaled ()
  for size_ = [1, 1e-3, 1e3]
    m = gsmbp_hand ("hand_fourbar");
    lengths = fieldnames (m.par)(strcmp (m.units.parameters, "m"))';
    given = [lengths; cellfun(@(n) size_ * m.par.(n), lengths, "UniformOutput", false)];
    m = gsmbp_set (m, given{:});
    x = gsmbp_assemble (m, m.initial, "tolerance", 1e-10 * size_);
    x(2) += 1e-5;
    gsmbp_check (sprintf ("%g times as large: 1e-5 rad off is an error", size_), ...
                 ! isempty (gsmbp_complaint (@() gsmbp_simulate (m, x, [0, 0.01]))));
    x(2) -= 1e-5 - 1e-8;
    gsmbp_check (sprintf ("%g times as large: 1e-8 rad off is none", size_), ...
                 isempty (gsmbp_complaint (@() gsmbp_simulate (m, x, [0, 0.01]))));
  end
  x = closed (m);
  m.nominal(4:6) = 1e4;   # speeds of ten thousand are usual: one of 1e-3 off is nothing
  x = gsmbp_assemble (m, x);
  x(5) += 1e-3;
  gsmbp_check ("speeds count beside m.nominal", ...
               isempty (gsmbp_complaint (@() gsmbp_simulate (m, x, [0, 1e-4]))));
end

## at a dead centre a small residual may hide a large move
function singular ()
  c = gsmbp_hand ("hand_crank", "parameters", struct ("l1", 0.2, "l2", 0.5));
  x = [0; 0; 0.7; 0; 0; 0];
  gsmbp_check ("a start in a dead centre is taken", ...
               isempty (gsmbp_complaint (@() gsmbp_simulate (c, x, [0, 0.01]))));
end

## gsmbp_assemble says where the constraints lose rank, of links in one line as of a spatial loop,
## in metres as in millimetres, and nowhere else
function lost_rank ()
  for l = [0.4, 4e-4]
    c = gsmbp_set (gsmbp_fixture ("event_dead_centre"), "r", l, "l", l);
    text = warned (c, [pi/2; pi; 0]);            # crank and rod of one length, folded up
    gsmbp_check ("folded slider-crank: rows are named", ...
                 any (strfind (text, "1 of the 2 constraints")) && any (strfind (text, "B.")));
    gsmbp_check ("beside: nothing is said", isempty (warned (c, [0.3; -0.6; 1.9 * l])));
  end
  for name = {"four_bar", "driven_fourbar", "rolling_disc", "free_crank", "close_spherical"}
    m = model (name{1});
    gsmbp_check ([name{1} ": nothing is said at its start"], ...
                 isempty (warned (m, m.initial(1:m.sizes.nq))));
  end
end

function text = warned (m, guess)
  lastwarn ("");
  evalc ("gsmbp_assemble (m, guess);");
  text = lastwarn ();
end

## the same rule where else a state comes in
function others ()
  m = gsmbp_fixture ("driven_fourbar");
  x = closed (m);
  bad = x;
  bad(2) += 0.1;
  gsmbp_linear (m, 0.3, x);
  says (@() gsmbp_linear (m, 0.3, bad), ...
        ["gsmbp_linear: driven_fourbar: expected a state on the constraints at t = " ...
         "0.3 s, found "]);
  ## the drive has moved since
  says (@() gsmbp_linear (m, 0, x), "expected a state on the constraints at t = 0 s");
  a = gsmbp_linear (m, 0.3, bad, [], "start", "project", "reduced", "none");
  b = gsmbp_linear (m, 0.3, m.prj (0.3, bad), [], "reduced", "none");
  gsmbp_check ("gsmbp_linear about the state moved", a.a - b.a, 0);
  says (@() gsmbp_simulate (m, bad, [0.3, 1], "start", "guess"), ...
        "option start: expected one of \"check\", \"project\", found \"guess\"");
  says (@() gsmbp_simulate (m, x, 1), ...
        "the times must be two or more, that of x0 first; found 1 alone");
  says (@() gsmbp_simulate (m, bad(1:2), [0.3, 1]), ...
        ["gsmbp_simulate: argument x0: expected 6 numbers (the states of " ...
         "driven_fourbar), found 2x1"]);
  s = gsmbp_fixture ("rolling_disc");
  flat = s.initial;
  flat(s.orientation(1,:)) = [1; 0; 0; 0];
  says (@() gsmbp_assemble (s, flat), "as a disc that lies flat on its plane");
  says (@() gsmbp_simulate (s, flat, [0, 1]), "as a disc that lies flat on its plane");
  x = s.initial;
  x(s.orientation(1,:)) = 0;
  says (@() gsmbp_simulate (s, x, [0, 1], "start", "project"), "which is no orientation");
end

## one Euler parameter held: what is the matter, not "the loop does not close"
function held_parameter ()
  m = gsmbp_fixture ("rolling_disc");
  for k = m.orientation(1,:)
    says (@() gsmbp_assemble (m, m.initial, "hold", m.coordinates{k}), ...
          sprintf (["option hold: %s is one of the Euler parameters (e0, e1, e2, e3) of one " ...
                    "orientation: hold all four, or none"], m.coordinates{k}));
  end
  x = gsmbp_assemble (m, m.initial, "hold", m.coordinates(m.orientation(1,:)));
  gsmbp_check ("all four may be held", x(m.orientation(1,:)) - m.initial(m.orientation(1,:)), ...
               1e-15);
end
