## Starts of many runs by the judgement of one alone: random ones of closed loops, at distances from
## the constraints that are in question, in ensembles and sweeps, whatever the threads.

function test_many_starts ()
  warning ("off", "gsmbp:singular", "local");
  crank = gsmbp_fixture ("case_02a_motor");
  bars = gsmbp_fixture ("design_fourbar");
  for s = {crank, 5; bars, 0; gsmbp_fixture("rolling_bead"), 0
           gsmbp_fixture("rolling_disc"), 0; gsmbp_fixture("lane_event_loop"), 0}'
    verdicts (s{:});
  end
  links (crank);
  without (gsmbp_fixture ("many_open"));
end

## a closed state of M, by chance
function x = closed (m)
  for k = 1:20
    guess = m.initial + 0.3 * (2 * rand (size (m.initial)) - 1);
    try
      x = gsmbp_assemble (m, guess);
      return;
    end
  end
  error ("no closed state of %s was found", m.name);
end

function [ok, said, x] = alone (m, x0, varargin)
  ok = true;
  said = x = "";
  try
    x = gsmbp_simulate (m, x0, [0, 1e-3], varargin{:}).x;
  catch err
    ok = false;
    said = regexprep (err.message, '^gsmbp_simulate: [^:]*: ', "");
  end
end

## starts at DISTANCES from closed ones, each beside the usual sizes
function verdicts (m, v)
  warning ("off", "gsmbp:rank", "local");
  rand ("twister", 5);
  distances = 10 .^ (-12:0.5:-2);
  rate = {"input", v}(1:2*(v != 0));
  [starts, good, said, first] = deal ([], [], {}, {});
  o = [rate, {"rtol", 1e-8, "atol", 1e-8}];
  for d = distances
    off = 2 * rand (size (m.initial)) - 1;
    starts(end+1,:) = closed (m) + d * m.nominal .* off;
    [good(end+1,1), said{end+1,1}, first{end+1}] = alone (m, starts(end,:)', o{:});
  end
  gsmbp_check ([m.name ": some starts are good, some not"], any (good) && any (! good));
  for lanes = [false, true](1:1 + any (strcmp (m.subroutines, "rhs_w")))
    e = gsmbp_ensemble (m, starts(find (good, 1),:), [0, 1e-3], o{:}, "starts", starts, "lanes", ...
                        lanes);
    what = sprintf ("%s, %d starts, lanes %d: ", m.name, rows (starts), e.lanes);
    gsmbp_check ([what "the same verdicts"], isequal (e.ok, logical (good)));
    gsmbp_check ([what "in the same words: " e.reason{end}], isequal (e.reason, said));
    same = cellfun (@(x, k) isempty (x) || isequal (x(1,:), e.x(1,:,k)), first, ...
                    num2cell (1:rows (starts)));
    gsmbp_check ([what "the same states on the constraints, bit for bit"], all (same));
  end
end

## ... of links that do not fit, in ensembles, sweeps and their programs
function links (m)
  x0 = closed (m);
  off = 10 .^ (-12:-2);
  table = struct ("l2", m.par.l2 * (1 + [0, off]));
  o = {"input", 5, "rtol", 1e-9, "atol", 1e-9};
  for i = 1:numel (table.l2)
    [good(i,1), said{i,1}] = alone (gsmbp_set (m, "l2", table.l2(i)), x0, o{:});
  end
  gsmbp_check ("links: some fit, some do not", any (good) && any (! good));
  e = gsmbp_ensemble (m, x0, [0, 1e-3], o{:}, "parameters", table);
  gsmbp_check ("links: the same verdicts and words", isequal (e.ok, logical (good)) ...
               && isequal (e.reason, said));
  folder = tempname ();
  tidy = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
  back = without_mpi ();
  o = [{x0, [0, 1e-3]}, o, {"vary", table, "plan", "grid"}];
  w = gsmbp_sweep (m, o{:});
  gsmbp_check ("links: a sweep, too", isequal (w.ok, logical (good)) && isequal (w.reason, said));
  p = gsmbp_sweep (m, o{:}, "program", folder);
  file = fullfile (folder, "sweep.h5");
  system (sprintf ("cd / && %s -o %s >/dev/null 2>&1", p.program, file));
  d = load ("-hdf5", file);
  short = cellstr (d.failed.reason);
  told = regexprep (said(! good), "; (close it by|try) gsmbp_assemble.*$", "");
  gsmbp_check (["links: its program, without words of Octave: " short{1}], ...
               isequal (logical (d.ok(:)), logical (good)) && isequal (short, told));
end

## a scene that has no way onto the constraints: what is told is no subroutine that it has not
function without (m)
  [l, q] = deal (m.par, 0.5);
  b = -q - asin (l.l1 * sin (q) / l.l2);
  x0 = [q; b; l.l1 * cos(q) + l.l2 * cos(q + b); 0; 0; 0];
  starts = [x0, x0 + [0; 1e-7; 0; 0; 0; 0], x0 + [0; 1e-3; 0; 0; 0; 0]]';
  o = {"loops", "baumgarte", "rtol", 1e-8, "atol", 1e-8};
  for i = 1:3
    [good(i,1), said{i,1}] = alone (m, starts(i,:), o{:});
  end
  e = gsmbp_ensemble (m, x0, [0, 1e-3], o{:}, "starts", starts);
  gsmbp_check (["no PRJ: " e.reason{3}], isequal (e.ok, [true; true; false]) ...
               && isequal (e.ok, logical (good)) && isequal (e.reason, said) ...
               && isempty (strfind (e.reason{3}, "PRJ")));
end
