## reference.m: the states of every case at 41 times, from gsmbp_simulate at the tightest tolerances,
## into <folder>/<scene>.txt (a row for each time: t, states, outputs).
## Arguments: the file of cases, the folder, with fortran_out of the scenes in the current one.

function one (line, folder)
  words = strsplit (strtrim (line));
  [name, kind] = deal (words{1}, words{3});
  tend = str2double (words{2});
  m = gsmbp_build (name);
  x = m.initial;
  v = zeros (m.sizes.nv, 1);
  for word = words(4:end)
    pair = strsplit (word{1}, "=");
    value = str2double (pair{2});
    x(strcmp (m.states, pair{1})) = value;
    v(strcmp (m.inputs, pair{1})) = value;
  endfor
  x = gsmbp_start (m, x, words(4:end));
  options = {"start", "project", "rtol", 1e-13, "input", v};
  if (strcmp (kind, "stiff"))
    options = [options, {"method", "dp853"}];
  endif
  t = linspace (0, tend, 41);
  warning ("off", "all", "local");
  r = gsmbp_simulate (m, x, t, options{:});
  y = zeros (numel (t), m.sizes.ny);
  if (m.sizes.ny > 0)
    for k = 1:numel (t)
      y(k,:) = m.out (t(k), r.x(k,:)', r.v(k,:)')';
    endfor
  endif
  dlmwrite (fullfile (folder, [name ".txt"]), [t(:), r.x, y], "delimiter", " ", ...
            "precision", "%.17g");
endfunction

## settled states that the case does not give stay as m.initial has them
function x = gsmbp_start (m, x, given)
endfunction

arguments = argv ();
lines = strsplit (fileread (arguments{1}), "\n");
for line = lines(cellfun (@(s) ! isempty (s) && s(1) != "#", lines))
  try
    one (line{1}, arguments{2});
  catch problem
    printf ("not ok reference of %s: %s\n", line{1}, problem.message);
  end_try_catch
endfor
