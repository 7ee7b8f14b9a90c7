## The global error of examples on the motions of their drivers, by dp853 and cvode: at most 100
## times the tolerance times the growth of a perturbation of the start. A planned motion of a closed
## chain is followed on one branch, however long the steps are.

function test_global_errors ()
  root = fullfile (fileparts (mfilename ("fullpath")), "..", "..");
  out = fullfile (getenv ("GSMBP_TEST_DIR"), "global_errors");
  build = @(name) gsmbp_build (name, "directory", out);
  scenes = {"four_bar/four_bar", "slider_crank/slider_crank", "pneumatic_position/pneumatic_axis"};
  for scene = scenes
    gsmbp_derive (fullfile (root, "examples", [scene{1} ".mac"]), out);
    [~, name] = fileparts (scene{1});
    [m, x0, t, options] = example_motion (name, build);
    bounded (name, m, x0, t(t <= 4), options(1:end-2));
  end
  [m, ~, ~, options] = example_motion ("four_bar", build);
  branch (m, options{2});
end

function bounded (name, m, x0, t, options)
  methods = {"dp853", "cvode"};
  ways = cellfun (@(method) {"method", method}, methods, "UniformOutput", false);
  tolerances = [1e-6, 1e-8, 1e-10];
  [e, growth] = global_errors (m, x0, t, options, ways, tolerances);
  for w = 1:numel (ways)
    gsmbp_check (sprintf ("%s, %s: error over tolerance and growth (%s)", name, methods{w}, ...
                          num2str (growth, 2)), e(w,:) ./ max (1, growth), 100);
  end
end

## a mechanism of millimetres and one of metres, times near and far: the same motion
function branch (m, plan)
  k = [1, 46, 131, 191, 201];
  for scale = [1e-3, 1]
    s = gsmbp_set (m, "la", 0.1 * scale, "lb", 0.25 * scale, "lc", 0.25 * scale, "ld", 0.2 * scale);
    guess = gsmbp_inverse (s, plan, 0).q;
    near = gsmbp_inverse (s, plan, 0:0.01:2, "guess", guess);
    far = gsmbp_inverse (s, plan, near.t(k), "guess", guess);
    gsmbp_check (sprintf ("four-bar times %g: one branch, rad", scale), far.q - near.q(k,:), 1e-9);
  end
end
