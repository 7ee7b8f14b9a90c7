## Mechanisms made by chance (seeded): trees and loops of all joint types, their tape evaluated in
## double precision by Maxima (tests/random/batch.mac) against the independent Newton-Euler
## formulation in maximal coordinates (independent/ne_*), at states drawn by chance.
##
## GSMBP_RANDOM is the number of mechanisms (default 30), GSMBP_RANDOM_LINKS how many links they may
## have (default 3), GSMBP_RANDOM_FIRST the seed of the first (default 1). tests/random/run COUNT
## FIRST LINKS sets them; make test-random asks for 2000 of up to 6 links. A residual may be 1e-10,
## times cond/1e6 where the matrix of the equations of motion is ill-conditioned (cond: of its
## nonzero singular values). At most one mechanism of a hundred may be left out, each with its
## reason printed.

function test_random ()
  here = fileparts (mfilename ("fullpath"));
  addpath (fullfile (here, "independent"), fullfile (here, "..", "random"));
  itself ();
  count = number_of ("GSMBP_RANDOM", 30);
  first = number_of ("GSMBP_RANDOM_FIRST", 1);
  work = fullfile (getenv ("GSMBP_TEST_DIR"), "random");
  [~, ~] = mkdir (work);
  tally = struct ("done", 0, "joints", struct ("tree", struct (), "cut", ...
      struct ()), "loops", zeros (1, 3), "worst", struct (), "excluded", {{}}, ...
                  "failed", {{}}, "removed", 0);
  waiting = {};
  step = max (1, min (50, ceil (count / 2)));
  for seed = first:step:first+count-1     # Maxima derives two lots while Octave makes the next one
    lot = prepared (seed:min (seed + step, first + count) - 1, work, ...
                    number_of ("GSMBP_RANDOM_LINKS", 3));
    if (numel (waiting) == 2)
      tally = judged (waiting{1}, tally, work);
      waiting(1) = [];
    end
    waiting{end + 1} = started (lot, work, here);
  end
  for lot = waiting
    tally = judged (lot{1}, tally, work);
  end
  for k = {{"tree", 7}, {"loop", 16}}(1:2 * (first == 1))   # the emitted Fortran of two of them
    tally = compiled (tally, k{1}{:});
  end
  report (tally, count);
end

function n = number_of (name, default)
  n = str2double (getenv (name));
  if (isnan (n))
    n = default;
  end
end

## The independent formulation against differences of its own positions, for a chain of all joints:
## on the way with constant speeds, points of every body (central differences in h and 2h combined:
## error h^4, rounding 1e-16/h^2; measured 1e-9).
function itself ()
  rand ("twister", 1);
  types = {"free", "helical", "cylindrical", "universal", "planar", "spherical", "spherical", ...
           "revolute", "prismatic", "fixed"};
  m = struct ("gravity", zeros (3, 1), "body", [], "joint", [], "loop", []);
  for b = 1:numel (types)
    m.body = [m.body, struct("mass", 1, "com", rand (3, 1), "inertia", eye (3))];
    more = {};
    if (b == 7)
      more = {"orientation", eye(3)(:, [3, 1, 3])};
    end
    ends = {[b - 1, b], [b, b - 1]}{1 + (b == 4)};
    m.joint = [m.joint, ne_joint("", types{b}, ends(1), ends(2), "point_a", rand (3, ...
        1), "point_b", rand (3, 1), "frame_a", ne_turn (rand (1, 4)), ...
                                 "frame_b", ne_turn (rand (1, 4)), "pitch", 0.3, more{:})];
  end
  [nq, nu] = ne_sizes (m);
  q = rand (sum (nq), 1);
  u = 2 * rand (sum (nu), 1) - 1;
  k = ne_rows (m, q, u);
  a = reshape (k.J \ k.gamma, 6, []);
  h = 2e-3;
  x = @(t) seen (ne_rows (m, ne_advance (m, q, t * u)));
  v = (8 * (x(h) - x(-h)) - (x(2 * h) - x(-2 * h))) / (12 * h);
  w = (16 * (x(h) + x(-h)) - (x(2 * h) + x(-2 * h)) - 30 * x(0)) / (12 * h^2);
  [velocity, acceleration] = deal ([]);
  for b = 1:numel (types)
    for e = [zeros(3, 1), k.R(:, :, b)]
      velocity = [velocity, k.v(:, b) + cross(k.w(:, b), e)];
      acceleration = [acceleration, ...
                      a(1:3, b) + cross(a(4:6, b), e) + cross(k.w(:, b), cross (k.w(:, b), e))];
    end
  end
  gsmbp_check ("independent formulation: velocities, a chain of all joints", v - velocity, 1e-8);
  gsmbp_check ("independent formulation: accelerations", w - acceleration, 1e-7);
end

## mass centres and the points one unit from them along the body's axes
function x = seen (k)
  x = [];
  for b = 1:columns (k.com)
    x = [x, k.com(:, b) + [zeros(3, 1), k.R(:, :, b)]];
  end
end

## ------------------------------------------------------------------------------ to Maxima and back

## mechanisms of the seeds with their states, their scenes written
function lot = prepared (seeds, work, most)
  lot.items = {};
  kinds = {"tree", "loop", "tree", "loop", "parallel", "tree", "loop", "loop", "tree", "loop", ...
           "tree", "loop", "spherical", "tree", "loop", "parallel"};
  for seed = seeds
    m = random_scene (seed, kinds{mod(seed - 1, numel (kinds)) + 1}, most);
    m.reactions = mod (seed, 3) == 0;     # one of three with the forces in all joints
    [states, reason] = random_states (m, 2);
    if (isempty (reason))
      write_scene (m, states, fullfile (work, [m.name ".mac"]));
    end
    lot.items{end + 1} = struct ("m", m, "states", states, "reason", reason);
  end
end

function write_scene (m, states, file)
  names = @(list) ["[" strjoin(list, ", ") "]"];
  fid = fopen (file, "w");
  joints = {[m.joint, m.loop].name};
  joints = joints(! strcmp ({[m.joint, m.loop].type}, "rolling") & m.reactions);
  fprintf (fid, ["%s\nrandom_reactions : %s$\nrandom_q : %s$\nrandom_u : %s$\nrandom_states : " ...
                 "[\n"], m.text, names (joints), names ([m.q, ...
        m.loop_q]), ...
           names ([m.u_own, m.loop_u]));
  lines = arrayfun (@(s) state_text (m, s), states, "UniformOutput", false);
  fprintf (fid, "%s]$\n", strjoin (lines, ",\n"));
  fclose (fid);
end

function text = state_text (m, s)
  [A, Adu] = own_speeds (m, s.q, s.u);
  text = sprintf ("[%s, %s, %s, %s]", exact (s.t), list ([s.q; s.loop_q]), ...
                  list ([A * s.u; s.loop_u]), list ([A * s.ud + Adu; 0 * s.loop_u]));
end

## the scene's speeds are A u, their rates A ud + Adu
function [A, Adu] = own_speeds (m, q, u)
  [A, Adu] = deal (eye (numel (u)), 0 * u);
  if (! isempty (m.speeds))
    [A, Adu] = m.speeds (q, u);
  end
end

## a double as an exact number
function text = exact (x)
  [f, e] = log2 (x);
  text = sprintf ("%d*2^(%d)", f * 2^53, e - 53);
end

function text = list (x)
  text = ["[" strjoin(arrayfun (@exact, x(:)', "UniformOutput", false), ", ") "]"];
end

function lot = started (lot, work, here)
  names = cellfun (@(x) ["\"" x.m.name "\""], ...
                   lot.items(cellfun (@(x) isempty (x.reason), lot.items)), "UniformOutput", ...
                   false);
  lot.log = fullfile (work, sprintf ("%s.log", lot.items{1}.m.name));
  root = fullfile (here, "..", "..");
  files = sprintf (["load(\"" root "/%s\")$ "], "gsmbp/gsmbp.mac", "tests/random/doubles.lisp", ...
                   "tests/random/batch.mac");
  statements = sprintf ("%srandom_batch(\"%s\", [%s])$", files, work, strjoin (names, ", "));
  lot.pid = system (sprintf (["exec env GSMBP_TIMEOUT=1200 '%s/share/make/maxima' '%s' '%s' " ...
                              ">'%s.sh' 2>&1"], ...
                             root, lot.log, statements, lot.log), false, "async");
end

function tally = judged (lot, tally, work)
  waitpid (lot.pid);
  for x = lot.items
    [m, states, reason] = deal (x{1}.m, x{1}.states, x{1}.reason);
    tally.done += 1;
    if (! isempty (reason))
      tally.excluded{end + 1} = [m.name ": " reason];
      continue;
    end
    file = fullfile (work, [m.name ".out"]);
    if (! exist (file, "file"))
      tally.failed{end + 1} = [m.name ": " why_not(fullfile (work, [m.name ".error"]), lot.log)];
      continue;
    end
    tally = counted (tally, m);
    [found, rest] = read_values (file, numel (states));
    for s = 1:numel (states)
      tally = compared (tally, m, states(s), rest, found{s});
    end
  end
end

function text = why_not (file, log)
  text = ["no result, see " log];
  if (exist (file, "file"))
    text = strtrim (strrep (fileread (file), "\n", " "));
  end
end

## what batch.mac wrote: values by state as structs, and the names of coordinates, speeds and rows
function [found, names] = read_values (file, states)
  text = strsplit (fileread (file), "\n");
  for k = 1:4
    words = strsplit (strtrim (text{k}), " ");
    names.(words{1}) = words(2:end);
  end
  [nq, nu, m] = deal (numel (names.q), numel (names.u), numel (names.rows));
  numbers = sscanf (strjoin (text(5:end), " "), "%f");
  numbers = numbers(1:2:end) .* 2 .^ numbers(2:2:end);
  wrenches = reshape (numbers(end-6*numel (names.reactions)*states+1:end), 6, [], states);
  numbers = reshape (numbers(1:end-numel (wrenches)), [], states);
  sizes = {"M", nu, nu; "bias", nu, 1; "tau", nu, 1; "qdot", nq, 1; "phi", m, 1; "phit", m, 1; ...
           "H", nu, m; "gamma", m, 1; "E", 5, 1};
  for s = 1:states
    first = 0;
    for k = 1:rows (sizes)
      n = sizes{k, 2} * sizes{k, 3};
      found{s}.(sizes{k, 1}) = reshape (numbers(first + (1:n), s), sizes{k, 2}, sizes{k, 3});
      first += n;
    end
    found{s}.H = found{s}.H';
    found{s}.wrench = wrenches(:, :, s);
  end
end

## --------------------------------------------------------------------------------- emitted Fortran

## one mechanism derived, compiled and compared, with the forces in all joints as outputs
function tally = compiled (tally, kind, seed)
  m = random_scene (seed, kind);
  m.name = ["compiled_" m.name];
  states = random_states (m, 3);
  joints = {[m.joint, m.loop].name};
  outputs = cellfun (@(j) sprintf (",\n  output(r_%s, reaction(%s))", j, j), joints, ...
                     "UniformOutput", false);
  file = fullfile (getenv ("GSMBP_TEST_DIR"), [m.name ".mac"]);
  fid = fopen (file, "w");
  fputs (fid, ...
         strrep (strrep (m.text, "])$", [outputs{:} "])$"]), ["\"" kind], ...
                 ["\"compiled_" kind]));
  closed = ! isempty (m.loop) || ! isempty (m.user);
  fprintf (fid, "requests : [kinematics, mass, bias, inverse, rhs, energy, output%s]$\n", ...
           {"", ", constraints"}{1 + closed});
  fclose (fid);
  derive = fullfile (fileparts (mfilename ("fullpath")), "..", "..", "share", "make", "derive");
  [code, text] = system (sprintf ("'%s' '%s' '%s' 2>&1", derive, file, ...
                                  fullfile (getenv ("GSMBP_TEST_DIR"), "fortran_out")));
  if (code)
    error ("%s: %s", m.name, text);
  end
  model = gsmbp_fixture (m.name);
  for s = states
    tally = compared (tally, m, s, ...
                      struct ("q", {model.coordinates(:)'}, "u", {model.speeds(:)'}, ...
                              "reactions", {joints}), called (model, m, s, joints));
  end
end

## the numbers of read_values from a compiled model, and its right-hand side
function found = called (model, m, s, joints)
  t = s.t;
  [A, Adu] = own_speeds (m, s.q, s.u);
  sorted = @(names, x, wanted) x(cellfun (@(n) find (strcmp (n, names)), wanted(:)'));
  q = sorted ([m.q, m.loop_q], [s.q; s.loop_q], model.coordinates);
  names = [m.u_own, m.loop_u];
  [u, ud] = deal (sorted (names, [A * s.u; s.loop_u], model.speeds), ...
                  sorted (names, [A * s.ud + Adu; 0 * s.loop_u], model.speeds));
  x = [q; u];
  [xd, ~] = model.rhs (t, x);             # angles near their singularity are no error
  found = struct ("M", model.mas (t, q), "bias", model.bia (t, q, u), "tau", model.inv (t, q, u, ...
      ud), "qdot", model.kin (t, q, u), "E", model.ene (t, x), ...
                  "xd", xd, "wrench", zeros (6, numel (joints)));
  [found.phi, found.phit, found.H, found.gamma] = deal (zeros (0, 1), zeros (0, 1), ...
      zeros (0, numel (u)), zeros (0, 1));
  if (any (strcmp (model.subroutines, "con")))
    [found.phi, found.phit, found.H, found.gamma] = model.con (t, q, u);
  end
  [y, ~] = model.out (t, x);
  parts = {"x", "y", "z", "mx", "my", "mz"};
  for k = 1:numel (y)
    word = strsplit (model.outputs{k}, ".");
    found.wrench(strcmp (word{2}, parts), strcmp (word{1}, strcat ("r_", joints))) = y(k);
  end
end

## --------------------------------------------------------------------------------------- residuals

## everything in the scene's own speeds v = A u
function tally = compared (tally, m, state, names, found)
  [q, u, ud] = deal (state.q, state.u, state.ud);
  [A, Adu] = own_speeds (m, q, u);
  k = ne_rows (m, q, u, state.t);
  [ud_free, ~, wrench, ud_loop] = ne_forward (m, q, u, 0 * u, state.t);
  [T, V, lost, given] = ne_energy (m, q, u);
  order = cellfun (@(x) find (strcmp (x, [m.u_own, m.loop_u])), names.u);
  order_q = cellfun (@(x) find (strcmp (x, [m.q, m.loop_q])), names.q);
  speeds = [A * u; state.loop_u](order);
  free = [A * ud_free + Adu; ud_loop](order);
  [ud_found, condition, rank_found] = solved (found);
  r.accelerations = norm (ud_found - free) / max (norm (free), 1);
  if (isfield (found, "xd"))
    r.right_hand_side = norm (found.xd(end-numel (free)+1:end) - free) / max (norm (free), 1);
  end
  r.energies = norm (found.E([1, 2, 4, 5])(:) - [T; V; given; lost]) / (abs (T) + abs (V) ...
        + abs (given) + abs (lost) + 1);
  r.kinetic_form = abs (speeds' * found.M * speeds / 2 - T) / (T + 1);
  ## a screw that is cut may bring its angle as a coordinate more
  own = order <= numel (u);
  if (! m.auto)                           # the same tree on both sides
    tree = setfield (setfield (m, "loop", []), "user", {});
    effort = @(ud) [A' \ ne_inverse(tree, q, u, ud); 0 * state.loop_u](order);
    [tau, bias] = deal (effort (ud), effort (-A \ Adu));
    B = (k.J \ k.E) / A;
    M = zeros (numel (order));
    M(own, own) = (B' * k.mass * B)(order(own), order(own));
    r.mass = norm (found.M - M) / norm (M);
    r.inverse = norm (found.tau - tau) / (norm (tau) + norm (M) * norm (ud) + 1);
    r.bias = norm (found.bias - bias) / (norm (bias) + 1);
    qdot = [ne_rates(m, q, u); 0 * state.loop_q](order_q);
    r.rates = norm (found.qdot(order_q <= numel (q)) ...
                      - qdot(order_q <= numel (q))) / (norm (qdot) + 1);
  end
  if (! isempty (found.phi))
    H = found.H;
    scale = norm (H);
    r.closed = norm (found.phi);
    r.closed_speeds = norm (H * speeds + found.phit) / (scale * norm (speeds) + 1);
    r.gamma = norm (H * free - found.gamma) / (scale * norm (free) + norm (found.gamma) + 1);
    if (! m.auto && all (own))
      wanted = (ne_jacobian (k) / A)(:, order);
      r.jacobian = norm (H * null (wanted)) / scale ...
          + (rank (wanted, 1e-9 * max (1, norm (wanted))) != rank_found);
    end
  elseif (! isempty (m.loop) || ! isempty (m.user))
    r.rows_lost = norm (ne_jacobian (k)) > 1e-9;
  end
  ## else they are not unique
  if (! isempty (names.reactions) && ! (rows (k.L) + rows (k.U) && ne_redundant (k)))
    order = cellfun (@(x) find (strcmp (x, {[m.joint, m.loop].name})), names.reactions);
    wrench = wrench(:, order);
    r.reactions = norm (found.wrench - wrench) / (norm (wrench) + 1);
  end
  limit = 1e-10 * max (1, 1e-6 * condition);
  for name = fieldnames (r)'
    now = r.(name{1}) / limit;
    if (! isfield (tally.worst, name{1}))
      tally.worst.(name{1}) = {0, ""};
    end
    if (! (now <= tally.worst.(name{1}){1}))
      tally.worst.(name{1}) = {now, m.name};
    end
    if (! (now <= 1))
      tally.failed{end + 1} = sprintf ("%s: %s %.1e (at most %.0e, condition %.0e)", m.name, ...
          name{1}, r.(name{1}), limit, condition);
    end
  end
end

## accelerations by the equations with multipliers, least norm where rows depend on each other; the
## condition without the zeros
function [ud, condition, r] = solved (found)
  [m, n] = size (found.H);
  n = rows (found.M);
  K = [found.M, -found.H'; found.H, zeros(m)];
  b = [-found.bias; found.gamma];
  r = 0;
  if (m)
    r = rank (found.H, 1e-9 * max (1, norm (found.H)));
  end
  s = svd (K);
  condition = s(1) / s(n + r);
  if (r == m)
    x = K \ b;
    x += K \ (b - K * x);
  else
    [U, S, V] = svd (K);
    x = V(:, 1:n+r) * ((U(:, 1:n+r)' * b) ./ s(1:n+r));
  end
  ud = x(1:n);
end

## ------------------------------------------------------------------------------------------ report

function tally = counted (tally, m)
  for place = {"tree", "cut"}
    for joint = {m.joint, m.loop}{1 + strcmp(place{1}, "cut")}
      if (! isfield (tally.joints.(place{1}), joint.type))
        tally.joints.(place{1}).(joint.type) = 0;
      end
      tally.joints.(place{1}).(joint.type) += 1;
    end
  end
  if (numel (m.loop))
    tally.loops(numel (m.loop)) += 1;
  end
end

function report (tally, count)
  cellfun (@(x) printf ("left out: %s\n", x), tally.excluded);
  cellfun (@(x) printf ("failed: %s\n", x), tally.failed);
  for place = {"tree", "cut"}
    types = sort (fieldnames (tally.joints.(place{1})))';
    counts = strjoin (cellfun (@(t) sprintf ("%s %d", t, tally.joints.(place{1}).(t)), types, ...
                               "UniformOutput", false), ", ");
    ## cut: no free joint, but rolling
    gsmbp_check (sprintf ("%s joints: %s", place{1}, counts), numel (types) == 9 || count < 200);
  end
  gsmbp_check (sprintf ("one, two, three loops: %d, %d, %d mechanisms", tally.loops), ...
               sum (tally.loops) > 0 || count < 8);
  for name = fieldnames (tally.worst)'
    gsmbp_check (sprintf ("%s, worst of all in units of its limit (%s)", ...
                          strrep (name{1}, "_", " "), tally.worst.(name{1}){2}), ...
                 tally.worst.(name{1}){1}, 1);
  end
  gsmbp_check (sprintf (["%d mechanisms by chance agree with Newton and Euler in maximal " ...
                         "coordinates"], ...
                        count), tally.done == count && isempty (tally.failed));
  gsmbp_check (sprintf ("%d left out, at most one of a hundred", numel (tally.excluded)), ...
               numel (tally.excluded) <= 0.01 * count);
end
