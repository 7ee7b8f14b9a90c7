## [w, notes] = peers_measured (s, peers): all measurements on a system, see peers_rows; NOTES: how
## far the other truth is off, what was left out.

function [w, notes] = peers_measured (s, peers)
  w = struct ("key", {}, "who", {}, "method", {}, "setting", {}, "seconds", {}, "calls", {}, ...
              "error", {});
  [truth, notes] = peers_others (w, s, peers, "truth", "");
  for one = truth
    notes{end+1} = sprintf ("beside the other truth, which is certain to %.0e: %.1e", ...
                            one.setting, one.error);
  end
  rates = {};
  try
    rates = {peers_casadi(s, peers)};
  catch problem
    notes{end+1} = problem.message;
  end
  tolerances = 10 .^ -(2:0.5:13.5);
  steps = 10 .^ -(1.5:0.25:3.5);
  none = {};
  ours = {"dp853", "rtol", tolerances, none; "rk4", "step", steps, none; ...
          "radau", "rtol", tolerances, none; "gauss", "step", steps, none};
  if (s.m.sizes.nlam > 0)
    ours = [ours; {"dp853", "rtol", tolerances, {"loops", "partitioning"}; ...
                   "dp853", "rtol", tolerances, {"loops", "baumgarte"}}];
  end
  mujoco = program (s, peers);
  words = sprintf ("'%s' %s %d", s.library, s.name, s.m.json.dimensions.ncst);
  others = {"mujoco_runs", ["'" mujoco "'"]; "scipy_runs", words; "drake_runs", ""};
  turns = [str2double(getenv ("TURNS")), 3];
  for turn = 1:turns(find (! isnan (turns), 1))
    w = peers_ours (w, s, "GSMBP", s.m, ours);
    if (s.m.sizes.nlam > 0)   # as CasADi's, which has no terms of Baumgarte's
      free = gsmbp_set (s.m, "baumgarte_alpha", 0, "baumgarte_beta", 0);
      w = peers_ours (w, s, "GSMBP", free, ours(strcmp (ours(:,1), "dp853"),:), ", alpha 0");
    end
    for m = rates
      w = peers_ours (w, s, "CasADi", m{1}, ours(strcmp (ours(:,1), "dp853") ...
                                                 | strcmp (ours(:,1), "rk4"),:));
    end
    for other = others'
      [w, left] = peers_others (w, s, peers, other{:});
      notes = unique ([notes, left], "stable");
    end
    for k = find (strcmp (others(:,1), "scipy_runs") | strcmp (others(:,1), "drake_runs"))'
      others(k,:) = {"mujoco_runs", ["'" mujoco "'"]};   # slow enough to need one turn
    end
  end
end

## MuJoCo's own loop in C
function file = program (s, peers)
  file = fullfile (s.folder, "mujoco_steps");
  site = fullfile (peers, "venv", "lib", "python3*", "site-packages", "mujoco");
  library = glob (fullfile (site, "libmujoco.so.*"));
  if (! isempty (library))
    folder = fileparts (library{1});
    source = fullfile (fileparts (mfilename ("fullpath")), "mujoco_steps.c");
    peers_shell (sprintf (["gcc -O3 -march=native -I'%s/include' '%s' '%s' -Wl,-rpath,'%s' -lm " ...
                           "-o '%s'"], folder, source, library{1}, folder, file));
  end
end
