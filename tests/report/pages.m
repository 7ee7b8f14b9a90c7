## pages (names, folder): the page of a short run of each of these examples and of the hostile
## scene, as tests/report/check opens them.

function pages (names, folder)
  root = fileparts (fileparts (fileparts (mfilename ("fullpath"))));
  addpath (fullfile (root, "octave"));
  for name = names
    try
      page (root, name{1}, folder);
    catch err
      printf ("not ok page of %s: %s\n", name{1}, err.message);
    end_try_catch
  endfor
endfunction

## from rest, loops closed, all inputs zero
function page (root, name, folder)
  warning ("off", "all");
  m = gsmbp_build (name);
  x0 = m.initial;
  if (m.sizes.nlam > 0)
    x0 = gsmbp_assemble (m, x0);
  endif
  [r, info] = gsmbp_simulate (m, x0, 0:0.02:10);
  gsmbp_report (m, r, fullfile (folder, [name ".html"]), "scene", ...
                fullfile (root, "examples", name, [name ".mac"]), "title", ...
                "<img src=x onerror=document.documentElement.dataset.hostile=1>");
endfunction
