## reference.m CASES OUT: for every case the states and outputs at 41 times from gsmbp_simulate, at
## tolerances far below those of the FMUs, into OUT/<scene>.txt (rows t, states, outputs). The
## Fortran of the scenes lies in fortran_out of the current folder.

function one (words, folder)
  [name, kind] = deal (words{1}, words{3});
  m = gsmbp_build (name);
  x = m.initial;
  v = zeros (m.sizes.nv, 1);
  for word = words(4:end)
    pair = strsplit (word{1}, "=");
    if (! any (strcmp ([m.states; m.inputs], pair{1})))
      error ("%s has no state or input %s", name, pair{1});
    endif
    x(strcmp (m.states, pair{1})) = str2double (pair{2});
    v(strcmp (m.inputs, pair{1})) = str2double (pair{2});
  endfor
  t = linspace (0, str2double (words{2}), 41);
  r = gsmbp_simulate (m, x, t, "start", "project", "rtol", 1e-13, "input", v);
  y = zeros (numel (t), m.sizes.ny);
  for k = 1:numel (t) * (m.sizes.ny > 0)
    y(k,:) = m.out (t(k), r.x(k,:)', r.v(k,:)')';
  endfor
  file = fopen (fullfile (folder, [name ".txt"]), "w");
  fprintf (file, [repmat("%.17g ", 1, 1 + columns (r.x) + columns (y)) "\n"], [t(:), r.x, y]');
  fclose (file);
endfunction

given = argv ();
warning ("off", "all");
for line = strsplit (fileread (given{1}), "\n")
  words = strsplit (strtrim (line{1}));
  if (numel (words) >= 3 && words{1}(1) != "#")
    try
      one (words, given{2});
    catch problem
      printf ("not ok reference of %s: %s\n", words{1}, problem.message);
    end_try_catch
  endif
endfor
