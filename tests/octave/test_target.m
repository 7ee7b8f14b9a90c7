## Controllers of gsmbp_model_control alone, as Fortran and C: compiled without the rest, they give
## for the measurements of a run the inputs of that run; on a tree and on a five-bar with a motor,
## for each law, with limits, steps, other parameters, samples where the loops do not close.

function test_target ()
  bar = gsmbp_fixture ("control_fivebar");
  e = at_rest (bar);
  swing = gsmbp_plan ("quintic", [e.x(1), 2.3; e.x(3), 0.9], [0, 0.2]);
  same (bar, e.x, swing, 4, "computed torque", "Kp", 400, "Kd", 40, "Ki", 900, "period", 5e-3, ...
        "trim", e, "limits", [24; 6], "parameters", struct ("m2", 1.3), "name", "torque");
  same (bar, e.x, swing, 4, "feedforward", "Kp", [80; 100], "Kd", [4; 5], "Ki", 20, "period", ...
        5e-3, "trim", e, "step_out", 0.01, "name", "forward");
  same (bar, e.x, swing, 4, "impedance", "K", [100; 60], "zeta", 0.7, "period", 5e-3, "trim", e, ...
        "name", "springs");
  arm = gsmbp_fixture ("control_arm");
  reach = gsmbp_plan ("quintic", [0.5, 0; -0.5, 1], [0, 0.2]);
  x0 = [0.6; -0.4; 0; 0];
  driven = {"period", 5e-3, "inputs", {"t1", "t2"}};
  same (arm, x0, reach, 2, "computed torque", "Kp", 100, "Kd", 20, "Ki", 50, "limits", [30; 8], ...
        driven{:}, "name", "tree_torque");
  same (arm, x0, reach, 2, "feedforward", "Kp", 50, "Kd", 5, "Ki", 30, driven{:}, "step_out", ...
        0.05, "name", "ahead");
  same (arm, x0, reach, 2, "impedance", "K", [80; 60], "zeta", 0.7, driven{:}, "name", "soft");
  numbers_compiled (x0, reach, driven);
  of_tools (bar, e);
  held (bar, e);
  refused (bar, e);
end

function e = at_rest (m)
  q = gsmbp_assemble (m, m.initial(1:4))(1:4);
  [v, ~, xa] = m.cmx (0, [q, zeros(4, 3)], zeros (m.sizes.nx, 1)(9:end));
  e = struct ("x", [q; zeros(4, 1); xa], "v", v);
end

## the run of the machine with the controller along a plan, against the controller alone
function same (m, x0, plan, n, law, varargin)
  c = gsmbp_model_control (m, law, varargin{:});
  mc = gsmbp_build (m.name, "directory", m.directory, "controller", c);
  t = (0:60) * c.period;
  r = gsmbp_simulate (mc, x0, t, "input", gsmbp_model_control (mc, "references", plan));
  against (law, m, c, r);
end

## a model whose Fortran has its numbers compiled in: it knows no parameters
function numbers_compiled (x0, reach, driven)
  folder = tempname ();
  guard = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
  mkdir (folder);
  scenes = fullfile (fileparts (fileparts (mfilename ("fullpath"))), "scenes");
  file = fullfile (folder, "control_arm.mac");
  f = fopen (file, "w");
  fprintf (f, ["load(\"%s\")$\n" ...
               "gsmbp_fortran(scene, all, [numbers = compiled, directory = \"%s\"])$\n"], ...
           fullfile (scenes, "control_arm.mac"), fullfile (folder, "compiled"));
  fclose (f);
  gsmbp_derive (file, fullfile (folder, "other"));
  m = gsmbp_build ("control_arm", "directory", fullfile (folder, "compiled"));
  gsmbp_check ("numbers compiled: no parameters", isempty (fieldnames (m.par)));
  same (m, x0, reach, 2, "computed torque", "Kp", 100, "Kd", 20, driven{:}, "name", "fixed");
end

function against (law, m, c, r)
  nv = m.sizes.nv;
  k = 1:numel (r.t) - 1;
  y = r.y(k,cellfun (@(name) find (strcmp (m.outputs, name)), c.measured));
  drives = cellfun (@(name) find (strcmp (m.inputs, name)), c.driven);
  [status, u] = compiled (m, c, [r.t(k), y, r.v(k,nv+1:end)]);
  nu = numel (drives);
  gsmbp_check ([law " alone: Fortran and C compile without a warning and run"], status == 0);
  wanted = r.samples.v(k,drives);
  gsmbp_check ([law " alone: Fortran gives the inputs of the run"], ...
               (u(:,1:nu) - wanted) ./ max (abs (wanted)), 1e-10);
  gsmbp_check ([law " alone: C as Fortran"], (u(:,nu+1:2*nu) - u(:,1:nu)) ./ max (abs (wanted)), ...
               1e-12);
end

## tools by their own axes, and in space
function of_tools (m, e)
  c = gsmbp_model_control (m, "cartesian impedance", "K", [800, 300, 0], "D", [60, 60, 0], ...
                           "axes", "tool", "period", 5e-3, "trim", e, "name", "hold");
  mc = gsmbp_build (m.name, "directory", m.directory, "controller", c);
  r = gsmbp_simulate (mc, e.x, (0:60) * 5e-3, "input", [20; 5; c.r0 + 0.01]);
  against ("tool", m, c, r);
  w = gsmbp_fixture ("control_wrist");
  c = gsmbp_model_control (w, "cartesian impedance", "K", [500, 400, 300, 20, 15, 10], "D", ...
                           [20, 20, 20, 1, 2, 3], "period", 1e-3, "name", "spatial");
  mc = gsmbp_build (w.name, "directory", w.directory, "controller", c);
  r = gsmbp_simulate (mc, w.initial, (0:40) * 1e-3, "input", c.r0 + [0.02; -0.01; 0.01; 0.1; ...
                      -0.1; 0.2; 0.1; 0; -0.1; 0.3; 0.1; -0.2]);
  against ("tool in space", w, c, r);
end

## a wanted motion that the loops cannot follow
function held (m, e)
  c = gsmbp_model_control (m, "feedforward", "Kp", [8; 10], "Kd", [4; 5], "period", 5e-3, ...
                           "trim", e, "parameters", struct ("l2", 0.3), "name", "far");
  mc = gsmbp_build (m.name, "directory", m.directory, "controller", c);
  plan = gsmbp_plan ("quintic", [e.x(1), 3.2; e.x(3), e.x(3)], [0, 0.2]);
  warning ("off", "gsmbp:held", "local");
  law = gsmbp_model_control (mc, "references", plan);
  r = gsmbp_simulate (mc, e.x, (0:60) * 5e-3, "input", law);
  one = r.stats.held;
  gsmbp_check ("samples without a command are counted", one.samples > 5 && one.samples < 61);
  k = find (r.samples.t == one.first);
  gsmbp_check ("... from the first one on", isscalar (k) && k > 1 ...
               && isequal (r.samples.v(k,[1, 4]), r.samples.v(k-1,[1, 4])) ...
               && ! isequal (r.samples.v(k-1,[1, 4]), r.samples.v(k-2,[1, 4])));
  warning ("error", "gsmbp:held", "local");
  said = gsmbp_complaint (@() gsmbp_simulate (mc, e.x, [0, 0.2], "input", law));
  told = "far had no command at \\d+ samples, the first at t = ";
  gsmbp_check ("... and told", ! isempty (regexp (said, told)));
  against ("held", m, c, r);
end

function refused (m, e)
  c = gsmbp_model_control (m, "impedance", "K", 1, "period", 1, "trim", e);
  arm = fullfile (fileparts (fileparts (mfilename ("fullpath"))), "scenes", "control_arm.mac");
  folder = tempname ();
  for row = {{c, folder}, "expected the file of this scene", {c, folder, "control_fivebar.mac"}, ...
             "there is no scene file control_fivebar.mac", {c, folder, arm}, ...
             "scene control_fivebar, found"}
    if (iscell (row{1}))
      args = row{1};
    else
      said = gsmbp_complaint (@() gsmbp_controller (args{:}));
      gsmbp_check (["refused: " row{1}], ! isempty (strfind (said, row{1})));
    end
  end
  gsmbp_check ("refused: nothing is written", ! isfolder (folder));
end

## what the controller's own Fortran and C give for rows of time, measurements, references
function [status, u] = compiled (m, c, table)
  folder = tempname ();
  guard = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
  scenes = fullfile (fileparts (fileparts (mfilename ("fullpath"))), "scenes");
  gsmbp_controller (c, folder, fullfile (scenes, [m.name ".mac"]));
  f = fopen (fullfile (folder, "main.c"), "w");
  fputs (f, strrep (strrep (main_program (), "NAME", upper (c.name)), "name", c.name));
  fclose (f);
  f = fopen (fullfile (folder, "in.txt"), "w");
  fprintf (f, [repmat("%.17g ", 1, columns (table)) "\n"], table');
  fclose (f);
  steps = ["cd %s && gfortran -std=legacy -O0 -frecursive -c %s.f && gcc -std=c99 -O0 " ...
           "-ffp-contract=off -Wall -Wextra -Werror -I. -o main *.c %s.o -lm -lgfortran 2>&1 " ...
           "&& ./main <in.txt"];
  [status, said] = system (sprintf (steps, folder, c.name, c.name));
  u = NaN (rows (table), 2 * numel (c.driven));
  if (status == 0)
    u = sscanf (said, "%g", [columns(u), Inf])';
  else
    puts (said);
  end
end

function text = main_program ()
  text = ["#include <stdio.h>\n#include \"name.h\"\n" ...
          "void name_ (double *, double *, double *, double *, double *);\n" ...
          "void name_start_ (double *, double *, double *, double *);\n" ...
          "int main (void)\n{\n" ...
          "  double t, y[NAME_MEASURED], r[NAME_REFERENCES], z[NAME_MEMORY], u[NAME_OUTPUTS],\n" ...
          "         zf[NAME_MEMORY], uf[NAME_OUTPUTS], p, d;\n" ...
          "  name_start (z, u);\n  name_start_ (zf, uf, &p, &d);\n" ...
          "  if (p != NAME_PERIOD || d != NAME_DELAY) return 1;\n" ...
          "  while (scanf (\"%lf\", &t) == 1) {\n" ...
          "    for (int i = 0; i < NAME_MEASURED; i++)\n" ...
          "      if (scanf (\"%lf\", y + i) != 1) return 2;\n" ...
          "    for (int i = 0; i < NAME_REFERENCES; i++)\n" ...
          "      if (scanf (\"%lf\", r + i) != 1) return 3;\n" ...
          "    name (t, y, r, z, u);\n    name_ (&t, y, r, zf, uf);\n" ...
          "    for (int i = 0; i < NAME_OUTPUTS; i++) printf (\"%.17g \", uf[i]);\n" ...
          "    for (int i = 0; i < NAME_OUTPUTS; i++) printf (\"%.17g \", u[i]);\n" ...
          "    printf (\"\\n\");\n  }\n  return 0;\n}\n"];
end
