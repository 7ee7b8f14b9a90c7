## robots.m: real robots (PyPI package example-robot-data) imported, derived, compiled; mass
## matrix and bias beside those of Pinocchio at five states each. Table: tests/bench/robots.md.
## ROBOTS="panda
## pr2": these only. The folder with the states is made by tests/bench/robots/run.

1;
function row = robot_of (file, out)
  r = jsondecode (fileread (file));
  [~, name] = fileparts (file);
  name = name(1:min (24, end));
  start = tic ();
  script = fullfile (out, [name "_import.mac"]);
  path = r.urdf;
  fid = fopen (script, "w");
  fprintf (fid, "load(\"%s/gsmbp/gsmbp.mac\")$\n", pwd ());
  fprintf (fid, ["gsmbp_import(\"%s\", directory = \"%s\", name = \"%s\", passive = false, ", ...
                 "overwrite = true)$\n"], path, out, name);
  fclose (fid);
  system (sprintf ("share/make/maxima %s.log 'batchload(\"%s\")$' >/dev/null", script, script));
  scene = fullfile (out, [name ".mac"]);
  seconds = toc (start);
  row = {name, NaN, seconds, NaN, NaN, NaN};
  if (! exist (scene, "file"))
    return;
  endif
  fid = fopen (scene, "a");
  fprintf (fid, "requests : [mass, bias]$\n");
  fclose (fid);
  start = tic ();
  gsmbp_derive (scene, out);
  m = gsmbp_build (name, "directory", out);
  m = gsmbp_set (m, "g", 9.81);
  row(2:6) = {m.sizes.nu, seconds, toc(start), 0, 0};
  for s = r.states(:)'
    q = s.q(:);
    u = s.u(:);
    row{5} = max (row{5}, max (abs (m.mas (0, q) - s.M)(:)) / max (abs (s.M(:))));
    row{6} = max (row{6}, max (abs (m.bia (0, q, u) - s.bias(:))) / max (abs (s.bias(:))));
  endfor
endfunction

addpath ([pwd "/octave"]);
folder = getenv ("GSMBP_ROBOTS");
files = glob (fullfile (folder, "*.json"))';
out = fullfile (folder, "out");
mkdir (out);
report = fopen ("tests/bench/robots.md", "w");
fprintf (report, ["# Robots of example-robot-data: mass matrix and bias beside Pinocchio's\n\n", ...
                  "Largest difference over the largest entry, five states each.\n\n", ...
                  "| robot | coordinates | import [s] | derived, compiled [s] | M | bias |\n", ...
                  "|---|---|---|---|---|---|\n"]);
for f = files
  try
    row = robot_of (f{1}, out);
  catch problem
    row = {f{1}, NaN, NaN, NaN, NaN, NaN};
    disp (problem.message);
  end_try_catch
  line = sprintf ("| %s | %d | %.1f | %.1f | %.1e | %.1e |\n", row{:});
  printf ("%s", line);
  fprintf (report, "%s", line);
  fflush (report);
endfor
fclose (report);
