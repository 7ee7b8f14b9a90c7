## stiff.m OUT: the run of stiff_loop by gsmbp_simulate with method radau into OUT, a row for each
## communication point of stiff.py: time and states.

m = gsmbp_set (gsmbp_fixture ("stiff_loop"), "c", 1e6);
r = gsmbp_simulate (m, m.initial, 0:0.05:1, "method", "radau", "rtol", 1e-10, "start", "project");
file = fopen (argv (){1}, "w");
fprintf (file, [repmat("%.17g ", 1, 1 + columns (r.x)) "\n"], [r.t(:), r.x]');
fclose (file);
