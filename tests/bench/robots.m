## robots.m: real robots (PyPI package example-robot-data) imported, derived, compiled; mass matrix
## and bias beside those of Pinocchio at five states each; inverse kinematics of their arms and legs
## there and back at 1000 positions. Tables: tests/bench/robots.md. ROBOTS="panda pr2": these only.
## The folder with the states is made by tests/bench/robots/run.

1;
## the scene file that gsmbp_import makes of a URDF file; "" where it makes none
function scene = imported (urdf, name, out, options)
  script = fullfile (out, [name "_import.mac"]);
  fid = fopen (script, "w");
  fprintf (fid, "load(\"%s/gsmbp/gsmbp.mac\")$\n", pwd ());
  fprintf (fid, ["gsmbp_import(\"%s\", directory = \"%s\", name = \"%s\", passive = false, ", ...
                 "overwrite = true%s)$\n"], urdf, out, name, options);
  fclose (fid);
  scene = fullfile (out, [name ".mac"]);
  [~, ~] = unlink (scene);
  system (sprintf ("share/make/maxima %s.log 'batchload(\"%s\")$' >/dev/null", script, script));
  if (! exist (scene, "file"))
    scene = "";
  endif
endfunction

function row = robot_of (file, out)
  r = jsondecode (fileread (file));
  [~, name] = fileparts (file);
  name = name(1:min (24, end));
  start = tic ();
  scene = imported (r.urdf, name, out, "");
  seconds = toc (start);
  row = {name, NaN, seconds, NaN, NaN, NaN};
  if (isempty (scene))
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

## row of the table: robot, link, joints, given, form, solutions of a pose, poses lost, largest part
## of a pose that a solution misses, largest difference of place and axes from Pinocchio's
function row = reach_of (file, out)
  r = jsondecode (fileread (file));
  [~, robot] = fileparts (file);
  name = [robot(1:min (18, end)) "_reach"];
  row = {robot, r.link, numel(r.chain), numel(r.given), "not imported", NaN, NaN, NaN, NaN};
  scene = imported (r.urdf, name, out, ", snap = 1e-4");
  if (isempty (scene))
    return;
  endif
  asked_for (scene, r);
  row{5} = "not derived";
  gsmbp_derive (scene, out);
  m = gsmbp_build (name, "directory", out);
  row{5} = "none";
  if (isfield (m, "ikn"))
    row(5:9) = [{m.json.reach.chains(1).form}, there_and_back(m, r)];
  endif
endfunction

## the link's frame (of a leg, three joints, its point) and the requests are written into the scene
function asked_for (scene, r)
  text = fileread (scene);
  coordinates = [regexp(text, 'coordinate = (\w+)', "tokens"){:}];
  kind = {"frame", "point"}{1 + (numel (r.chain) == 3)};
  text = strrep (text, "\n  parameters = ", ...
                 sprintf ("\n  %s(bench_tool, %s),\n  parameters = ", kind, r.link));
  given = strjoin (coordinates(r.given(:)' + 1), ", ");
  fid = fopen (scene, "w");
  fprintf (fid, "%s", text);
  fprintf (fid, ["requests : [points, point_jacobians, ", ...
                 "inverse_kinematics(bench_tool, given = [%s])]$\n"], given);
  fclose (fid);
endfunction

function row = there_and_back (m, r)
  chain = r.chain(:)' + 1;
  given = r.given(:)' + 1;
  own = setdiff (chain, given, "stable");
  turns = strcmp ({m.json.coordinates(own).unit}', "rad");
  whole = m.json.reach.whole;
  [number, lost, miss, off] = deal (0);
  for k = 1:rows (r.q)
    q = zeros (m.sizes.nq, 1);
    q(chain) = r.q(k,:);
    [P, R] = m.pnt (0, q);
    if (k <= rows (r.P))
      off = max ([off; abs(P - r.P(k,:)'); whole * abs(R - squeeze (r.R(k,:,:)))(:)]);
    endif
    if (isempty (given))
      [qs, ns] = m.ikn (P, R);
    else
      [qs, ns] = m.ikn (P, R, q(given));
    endif
    number += ns;
    d = qs(:,1:ns) - q(own);
    d -= turns .* (2 * pi * round (d / (2 * pi)));
    J = m.jpt (0, q, zeros (m.sizes.nu, 1))(1:3 * (1 + whole),own);
    lost += ! (ns > 0 && min (max (abs (d), [], 1)) < 1e-6 + 4e-15 * cond (J));
    for s = 1:ns
      q(own) = qs(:,s);
      [p, a] = m.pnt (0, q);
      miss = max ([miss; abs(p - P); whole * abs(a - R)(:)]);
    endfor
  endfor
  row = {number / rows(r.q), lost, miss, off};
endfunction

function line = table_line (format, cells)
  line = [sprintf(format, cells{:}) "\n"];
  printf ("%s", line);
  fflush (stdout);
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
  fputs (report, table_line ("| %s | %d | %.1f | %.1f | %.1e | %.1e |", row));
  fflush (report);
endfor
fprintf (report, ["\n# Inverse kinematics of their arms and legs\n\n1000 positions by chance: ", ...
                  "is the position among the solutions for its pose, does every solution have ", ...
                  "the pose?\nImported with snap = 1e-4 (angles of the files are rounded); ", ...
                  "what that changes is in the last column.\n\n", ...
                  "| robot | link | joints | given | form | solutions of a pose | lost | ", ...
                  "missed of the pose | off Pinocchio's |\n", ...
                  "|---|---|---|---|---|---|---|---|---|\n"]);
for f = glob (fullfile (folder, "reach", "*.json"))'
  row = {f{1}, "", NaN, NaN, "failed", NaN, NaN, NaN, NaN};
  try
    row = reach_of (f{1}, out);
  catch problem
    disp (problem.message);
  end_try_catch
  fputs (report, table_line ("| %s | %s | %d | %d | %s | %.2f | %d | %.1e | %.1e |", row));
  fflush (report);
endfor
fclose (report);
