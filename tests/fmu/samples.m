## samples.m OUT LATE: runs of sampled_inputs by gsmbp_simulate with inputs that change at the
## communication points of samples.py, into OUT/<parts of a period>.txt, a row for each point: time,
## angle and speed, memory and held outputs after the sample that is due there, the two outputs.

function k = places (all, names)
  k = cellfun (@(name) find (strcmp (all, name)), names);
endfunction

function rows = run_of (m, h, n)
  k = 0:n+1;   # the sample at the end of a run does not belong to it: one point more
  inputs = zeros (m.sizes.nv, n + 2);
  inputs(strcmp (m.inputs, "wanted"),:) = 0.5 * sin (1.3 * k);
  inputs(strcmp (m.inputs, "load"),:) = 0.4 * cos (2.1 * k);
  r = gsmbp_simulate (m, [0.31 -0.2], k * h, "input", mkpp ((0:n+2) * h, inputs, m.sizes.nv), ...
                      "rtol", 1e-13);
  of_importer = ismember (m.inputs, {"wanted", "load"});
  held = places (m.inputs, {"E.angle", "E.speed", "C.out", "L.out"});
  outputs = places (m.outputs, {"torque", "ahead"});
  rows = zeros (n + 1, 12);
  for i = 1:n+1
    last = find (r.samples.t <= r.t(i) * (1 + 1e-12), 1, "last");
    v = r.samples.v(last,:)';
    v(of_importer) = inputs(of_importer,i);
    y = m.out (r.t(i), r.x(i,:)', v);
    rows(i,:) = [r.t(i), r.x(i,:), r.samples.xk(last,:), v(held)', y(outputs)'];
  endfor
endfunction

words = argv ();
m = gsmbp_set (gsmbp_fixture ("sampled_inputs"), "late", str2double (words{2}));
for parts = 1:3
  file = fopen (fullfile (words{1}, sprintf ("%d.txt", parts)), "w");
  fprintf (file, [repmat("%.17g ", 1, 12) "\n"], run_of (m, 0.1 / parts, 15 * parts)');
  fclose (file);
endfor
