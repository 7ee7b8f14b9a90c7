## poses.m: pose and Jacobian of a frame at the end of a chain, called by `make bench-poses`:
## emitted PNJ and PNR (with (dJ/dt) u), PNT and JPT one after the other, beside CasADi in the
## Python environment that rivals/setup makes (PEERS: its folder; left out: ours alone). Writes
## poses.md beside itself.

1;
## the scene of a system with a frame at its last link, as FOLDER/NAME.mac
function with_frame (system, n, folder)
  text = fileread (system);
  text = strrep (text, "parameters = [", ...
                 sprintf (["frame(tcp, link%d, at = [hx, hy, hz]), parameters = [hx = 0.05*m, " ...
                           "hy = 0.02*m, hz = 0.1*m, "], n));
  [~, name] = fileparts (system);
  file = fopen (fullfile (folder, [name ".mac"]), "w");
  fputs (file, [text "requests : [points, point_jacobians, pose_jacobians, pose_rates]$\n"]);
  fclose (file);
end

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"), fullfile (here, "speed"), fullfile (here, "loops"));
peers = getenv ("PEERS");
lines = {};
for name = {"puma3", "puma6", "spat6", "pend8", "spat16"}
  n = str2double (regexp (name{1}, '\d+', "match", "once"));
  s = struct ("name", name{1}, "n", n, "loop", false, ...
              "folder", fullfile (here, "out", "poses", name{1}));
  s.model = fullfile (s.folder, "model.txt");
  [~, ~] = mkdir (s.folder);
  with_frame (fullfile (here, "systems", [name{1} ".mac"]), n, s.folder);
  scene = fullfile (s.folder, [name{1} ".mac"]);
  speed_cpu (sprintf ("'%s/share/make/derive' '%s' '%s'", root, scene, s.folder));
  speed_cpu (sprintf (["cd '%s' && gfortran -O3 -march=native -frecursive -fPIC -shared " ...
                       "-fopenmp-simd -DNAME=%s -DN=%d %s.f %s/share/fortran/functions/*.f " ...
                       "%s/points/ours_pose.c -Wl,-Bsymbolic -o ours.so"], s.folder, name{1}, n, ...
                       name{1}, root, here));
  library = fullfile (s.folder, "ours.so");
  jobs = [speed_job("gsmbp", "lit", "pj", library, "-", "pj", 12 + 6 * n), ...
          speed_job("gsmbp", "lit", "pjd", library, "-", "pjd", 18 + 6 * n), ...
          speed_job("two", "lit", "pj", library, "-", "both", 18 + 6 * n)];
  if (! isempty (peers))
    speed_cpu (sprintf (["'%s/share/make/maxima' '%s/log' 'load(\"%s/gsmbp/gsmbp.mac\")$ " ...
                         "load(\"%s/speed/speed.mac\")$ speed_model(\"%s\", \"%s\")$'"], root, ...
                        s.folder, root, here, scene, s.model));
    speed_cpu (sprintf (["'%s/venv/bin/python' '%s/points/casadi_pose.py' '%s' '%s' && cd '%s' " ...
                         "&& gcc -O3 -march=native -fno-semantic-interposition -shared -fPIC " ...
                         "pj.c pjd.c par.c -lm -Wl,-Bsymbolic -o casadi.so"], peers, here, ...
                         s.model, s.folder, s.folder));
    library = fullfile (s.folder, "casadi.so");
    jobs = [jobs, speed_job("casadi", "lit", "pj", library, "-", "pj", 12 + 6 * n), ...
            speed_job("casadi_rate", "lit", "pj", library, "-", "pjd", 18 + 6 * n)];
  end
  [jobs(1:3).start] = deal (s.model);    # their init is called with it
  X = speed_states (s, "random", 256);
  values = speed_run (s, X, jobs, "values");
  ns = speed_run (s, X, jobs, "time", 42);
  one = @(k) sprintf ("%.1f", median (ns(k,:)));
  ratio = @(k, l) sprintf ("%.2f", median (ns(k,:) ./ ns(l,:)));
  row = {name{1}, one(1), one(2), one(3), ratio(1, 3), ratio(2, 3)};
  if (numel (jobs) > 3)
    off = max (max (abs (values{1} - values{4})));
    off = max (off, max (max (abs (values{2} - values{5}))));
    row = [row, {one(4), ratio(1, 4), one(5), ratio(2, 5), sprintf("%.1e", off)}];
  end
  lines{end+1} = row;
end
head = {"system", "PNJ ns", "PNR ns", "PNT + JPT ns", "PNJ : both", "PNR : both", "CasADi ns", ...
        "PNJ : CasADi", "CasADi with (dJ/dt) u ns", "PNR : that", "largest difference"};
text = speed_table ("Pose and Jacobian of a tool", ...
                    ["Place, axes and Jacobian of a frame at the end of a chain, parameters at " ...
                     "run time, medians of 42 rounds\nin which all take turns. CasADi: the " ...
                     "chain with its symbols, J by its derivative and columns of axes,\ncse. " ...
                     "PNR and PNT + JPT have (dJ/dt) u, too."], head(1:numel (lines{1})), lines);
if (isempty (text))
  error ("bench-poses: the table is empty");
end
bench_save (fullfile (here, "poses.md"), text);
puts (text);
