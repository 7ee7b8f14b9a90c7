## linear (FILE): linear models of scenes by gsmbp_linear, written as JSON, for linear.py.

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
  fputs (fid, jsonencode (r));
  fclose (fid);
end

function r = model (m, x, v, varargin)
  [sys, T, k, dropped] = gsmbp_linear (m, 0, x, v, varargin{:});
  part = @(a) struct ("size", size (a), "numbers", a(:)');
  r = struct ("x", x(:)', "v", v(:)', "options", {varargin}, "a", part (sys.a), ...
              "b", part (sys.b), "c", part (sys.c), "d", part (sys.d), "tangent", part (T), ...
              "independent", k - 1, "states", {sys.stname}, "outputs", {sys.outname}, ...
              "dropped", {dropped});
end
