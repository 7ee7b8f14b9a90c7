## linear (FILE): linear models, equilibria, modes and inverse kinematics of scenes by Octave's
## functions, written as JSON, for linear.py.

function linear (file)
  warning ("off", "all");
  pkg load control
  r = struct ();
  m = gsmbp_fixture ("control_arm");
  r.control_arm = {model(m, [0.4; -0.7; 0.2; 0.5], [3; 1; -2])};
  m = gsmbp_fixture ("case_03a");
  x = gsmbp_assemble (m, [m.initial(1:3); 1.5; 0; 0], "hold", "theta");
  r.case_03a = {model(m, x, []), model(m, x, [], "reduced", "psi"), ...
                model(m, x, [], "reduced", "none")};
  m = gsmbp_fixture ("case_02a_motor");
  r.case_02a_motor = {model(m, m.initial, ones (m.sizes.nv, 1))};
  m = gsmbp_fixture ("trim_hydraulic");
  r.trim_hydraulic = {model(m, m.initial, 0.1 * ones (m.sizes.nv, 1))};
  m = gsmbp_fixture ("steady_disc");
  x = m.initial;
  x(strcmp (m.states, "spin_d")) = 2;
  x = gsmbp_trim (m, x, [], "steady", "spin").x;
  r.steady_disc = {model(m, x, []), model(m, x, [], "drop", "running"), ...
                   model(m, x, [], "drop", {"x", "y", "yaw", "spin"})};
  m = gsmbp_fixture ("orient_free");
  r.orient_free = {model(m, m.initial, zeros (m.sizes.nv, 1))};
  fid = fopen (file, "w");
  fputs (fid, jsonencode (struct ("linear", r, "trim", trims (), ...
                               "modes", vibrations (), "reach", reaches (), ...
                               "campbell", diagrams (), "assemble", assemblies ())));
  fclose (fid);
end

function r = model (m, x, v, varargin)
  [sys, T, k, dropped] = gsmbp_linear (m, 0, x, v, varargin{:});
  part = @(a) struct ("size", size (a), "numbers", a(:)');
  r = struct ("x", x(:)', "v", v(:)', "options", {varargin}, "a", part (sys.a), ...
              "b", part (sys.b), "c", part (sys.c), "d", part (sys.d), "tangent", part (T), ...
              "independent", k - 1, "states", {sys.stname}, "outputs", {sys.outname}, ...
              "dropped", {dropped});
  if (! any (strcmp (m.subroutines, "mas")))
    return;
  end
  s = gsmbp_mck (m, 0, x, v, varargin{:});
  for name = {"M", "C", "K", "B", "E", "D", "G", "S", "N"}
    r.mck.(name{1}) = part (s.(name{1}));
  end
  r.mck.names = {s.coordinates, s.speeds, s.devices};
end

## rough states of a four-bar and of a free body in Euler parameters, closed
function r = assemblies ()
  m = gsmbp_fixture ("case_03a");
  rough = [1.1; -0.6; 1.4; 1.5; 0; 0];
  r.case_03a = {assembly(m, rough), assembly(m, rough(1:3)), ...
                assembly(m, rough, "hold", "theta"), assembly(m, rough, "hold", "psi"), ...
                assembly(m, rough, "hold", "theta", "branches", 12)};
  m = gsmbp_fixture ("orient_free");
  r.orient_free = {assembly(m, m.initial + 0.1)};
end

function r = assembly (m, guess, varargin)
  x = gsmbp_assemble (m, guess, varargin{:});
  r = struct ("guess", guess(:)', "options", {varargin}, "x", ...
              struct ("size", size (x), "numbers", x(:)'));
end

function r = trims ()
  r = struct ();
  m = gsmbp_fixture ("control_arm");
  r.control_arm = {trim(m, [0.4; -0.7; 0; 0], [], "hold", {"q1", "q2"}, "free", {"t1", "t2"})};
  m = gsmbp_fixture ("case_03a");
  r.case_03a = {trim(m, [1.1; -0.74; 1.23], [], "hold", "theta", "free", "tau_a"), ...
                trim(m, [1.1; -0.74; 1.23], [])};
  m = gsmbp_fixture ("case_02a_motor");
  r.case_02a_motor = {trim(m, m.initial, [], "hold", "theta", "free", m.inputs{1})};
  m = gsmbp_fixture ("trim_hydraulic");
  r.trim_hydraulic = {trim(m, m.initial, [], "hold", "x", "free", m.inputs{1})};
  m = gsmbp_fixture ("steady_disc");
  x = m.initial;
  x(strcmp (m.states, "spin_d")) = 2;
  r.steady_disc = {trim(m, x, [], "steady", "spin")};
end

function r = trim (m, x, v, varargin)
  s = gsmbp_trim (m, x, v, varargin{:});
  r = struct ("guess", x(:)', "inputs", v(:)', "options", {varargin}, "x", s.x(:)', ...
              "v", s.v(:)', "lambda", s.lambda(:)', "way", s.way, "running", {s.running}, ...
              "indifferent", {s.indifferent}, "unique", s.unique(:)');
end

function r = vibrations ()
  r = struct ();
  m = gsmbp_fixture ("control_arm");
  r.control_arm = {vibration(m, [-pi/2; 0]), vibration(m, [-pi/2; 0.3], "hold", "q2"), ...
                   vibration(m, [-1.2; 0.4], "steady", true)};
  m = gsmbp_fixture ("case_03a");
  r.case_03a = {vibration(m, gsmbp_trim (m, [-1.1; -0.74; 1.23], []).x)};
  m = gsmbp_fixture ("case_02a_motor");
  r.case_02a_motor = {vibration(m, gsmbp_trim (m, [-1.4; 1.2; -0.5], []).x)};
  m = gsmbp_fixture ("trim_hydraulic");
  s = gsmbp_trim (m, m.initial, [], "hold", "x", "free", m.inputs{1});
  r.trim_hydraulic = {vibration(m, s.x, "input", s.v)};
  m = gsmbp_fixture ("modes_arm");
  x = m.initial;
  x(strcmp (m.states, "theta_d")) = 5;
  r.modes_arm = {vibration(m, x, "hold", {"q1", "q2", "theta"}), ...
                 vibration(m, [0.4; -1.2; x(3:end)], "hold", {"q1", "theta"}, "steady", true)};
end

function r = vibration (m, x, varargin)
  s = gsmbp_modes (m, x, varargin{:});
  parts = @(z) struct ("re", real (z(:))', "im", imag (z(:))');
  v = [varargin(2:2:end)(strcmp (varargin(1:2:end), "input")), {[]}]{1};
  k = 2 * find (! strcmp (varargin(1:2:end), "input"));
  r = struct ("guess", x(:)', "inputs", v(:)', "options", {varargin(sort ([k - 1, k]))}, ...
              "frequency", s.frequency', "damping", s.damping', "eigenvalues", ...
              parts (s.eigenvalues), "shapes", parts (s.shapes), "real", s.real', "rigid", ...
              s.rigid, "x", s.x');
end

function r = diagrams ()
  m = gsmbp_fixture ("modes_arm");
  x = m.initial;
  r.modes_arm = {diagram(m, x, "theta", [0, 2, 5, 9], "hold", "q1"), ...
                 diagram(m, x, "theta", [1, 3], "steady", true)};
  m = gsmbp_fixture ("control_arm");
  r.control_arm = {diagram(m, [-pi/2; 0; 0; 0], "q2", 0)};
end

function r = diagram (m, x, spin, speeds, varargin)
  s = gsmbp_modes (m, x, "spin", spin, "speeds", speeds, varargin{:});
  part = @(a) struct ("size", size (a), "re", real (a(:))', "im", imag (a(:))');
  r = struct ("guess", x(:)', "spin", spin, "speeds", speeds, "options", {varargin}, ...
              "real", {s.real}, "rigid", s.rigid);
  for name = {"frequency", "damping", "eigenvalues", "shapes", "x"}
    r.(name{1}) = part (s.(name{1}));
  end
end

function r = reaches ()
  m = gsmbp_fixture ("reach_puma");
  q = [0.3, 0.5, 0.9; -0.6, -0.2, 0.3; 0.8, 0.6, 0.4; 0.2, 0.1, -0.4; 0.7, 0.4, 0; 0.1, 0.3, 0.6];
  P = zeros (3, 4);
  R = repmat (eye (3), 1, 1, 4);
  for k = 1:3
    [P(:,k), R(:,:,k)] = m.pnt (0, q(:,k));
  end
  P(:,4) = [3; 0; 0];
  limits = [-0.2, 7; repmat([-3, 3], 5, 1)];
  r.reach_puma = {one_reach(m, "tool", P, R), ...
                  one_reach(m, "tool", P, R, "start", q(:,1) + 0.1), ...
                  one_reach(m, "tool", P, R, "branch", 2), ...
                  one_reach(m, "tool", P, R, "limits", limits), ...
                  one_reach(m, "tool", P, R, "method", "newton", "start", q(:,1) + 0.1), ...
                  one_reach(m, "tool", P(:,1:3), [], "start", q(:,1))};
  m = gsmbp_fixture ("reach_crank");
  q = gsmbp_assemble (m, [0.7; -1; 0.5], "hold", "q1")(1:3);
  r.reach_crank = {one_reach(m, "pin", m.pnt (0, q), [], "start", [0.5; -0.8; 0.5])};
  m = gsmbp_fixture ("reach_seven");
  q = [0.3; 0.5; -0.2; 1.1; 0.4; 0.6; -0.3];
  [P, R] = m.pnt (0, q);
  r.reach_seven = {one_reach(m, m.points{1}, P, R, "given", q(strcmp (m.coordinates, ...
                                                       m.json.reach.given{1})), "start", q)};
end

function r = one_reach (m, name, P, R, varargin)
  [q, s] = gsmbp_reach (m, name, P, R, varargin{:});
  part = @(a) struct ("size", size (a), "numbers", a(:)');
  r = struct ("name", name, "P", part (P), "R", part (R), "options", {varargin}, ...
              "q", part (q), "status", {s.status}, "distance", part (s.distance), ...
              "branch", s.branch, "solutions", {cellfun(@columns, s.solutions)}, ...
              "free", part (abs (s.free)));
end
