## s = peers_scene (row, out): the system of a row {name, end [s], start of the coordinates, of the
## speeds} of peers.m, derived and built in OUT/NAME, with model.txt and start.txt for the rivals.
##
## s: name, folder, m (the model), end, x0, options (of gsmbp_simulate), truth (coordinates at the
## end by the same Fortran in quad precision), library (its Fortran for ctypes).

function s = peers_scene (row, out)
  root = fileparts (fileparts (fileparts (fileparts (mfilename ("fullpath")))));
  [s.name, s.end, q, v] = row{:};
  s.folder = fullfile (out, s.name);
  [~, ~] = mkdir (s.folder);
  file = fullfile (s.folder, [s.name ".mac"]);
  peers_write (file, sprintf ("load(\"%s\")$\nrequests : [all, lanes]$\n", ...
                              fullfile (root, "tests", "bench", "systems", [s.name ".mac"])));
  gsmbp_derive (file, s.folder);
  build = {"directory", s.folder, "build", fullfile(out, "build")};
  s.m = gsmbp_build (s.name, build{:});
  s.options = {};
  if (s.m.sizes.nlam > 0)
    [q, v] = closed (s.m.par, q, v);
    s.options = {"input", 0};
  end
  s.x0 = [q, v];
  model_of (root, s);
  peers_write (fullfile (s.folder, "start.txt"), sprintf ("%.17g\n", s.end, s.x0));
  quad = gsmbp_build (s.name, build{:}, "precision", "quad", "parameters", s.m.par);
  r = gsmbp_simulate (quad, s.x0, [0, s.end], s.options{:}, "method", "dp853", "rtol", 1e-18, ...
                      "atol", 1e-18, "drift", false);
  s.truth = r.x(end,1:s.m.sizes.nq);
  s.library = library_of (root, out, s);
end

## the scene's Fortran and the run time as one library
function library = library_of (root, out, s)
  library = fullfile (s.folder, "rates.so");
  built = {fullfile(out, "build"), fullfile(root, "fortran_out", "build")};
  archive = fullfile (built, "double", "common", "libgsmbp.a");
  archive = archive{find (cellfun (@(f) exist (f, "file") == 2, archive), 1)};
  peers_shell (sprintf (["gfortran -O3 -fno-tree-slp-vectorize -march=native -frecursive -fPIC " ...
                         "-shared '%s' '%s' -llapack -lblas -o '%s'"], ...
                        fullfile (s.folder, [s.name ".f"]), archive, library));
end

## the slider-crank with its pin closed, from the crank's angle and speed
function [q, v] = closed (p, q, v)
  rod = -asin (p.l1 * sin (q) / p.l2);
  rate = -p.l1 * cos (q) * v / (p.l2 * cos (rod));
  q = [q, rod - q, p.l1 * cos(q) + p.l2 * cos(rod)];
  v = [v, rate - v, -p.l1 * sin(q(1)) * v - p.l2 * sin(rod) * rate];
end

## model.txt, see rivals/model.hpp: of a chain from Maxima
function model_of (root, s)
  file = fullfile (s.folder, "model.txt");
  if (s.m.sizes.nlam > 0)
    peers_write (file, slider_crank (s.m.par));
    return;
  end
  statement = sprintf (["load(\"%s/gsmbp/gsmbp.mac\")$ load(\"%s\")$ " ...
                        "speed_model(\"%s\", \"%s\")$"], ...
                       root, fullfile (root, "tests", "bench", "speed", "speed.mac"), ...
                       fullfile (s.folder, [s.name ".mac"]), file);
  peers_shell (sprintf ("'%s' '%s' '%s'", fullfile (root, "share", "make", "maxima"), ...
                        fullfile (s.folder, "model.log"), statement));
end

## its slider's axis is x of the ground; the last number is where the rod is pinned
function text = slider_crank (p)
  link = @(parent, kind, R, at, m, c, J) ...
      sprintf ("%d %s%s\n", parent, kind, sprintf (" %.17g", R, at, m, c, 0, 0, J, 0, 0, 0));
  turn = [1, 0, 0, 0, 1, 0, 0, 0, 1];
  text = [sprintf("3\n0 %.17g 0\n", -p.g), ...
          link(-1, "R", turn, [0, 0, 0], p.m1, p.c1, [p.jxx1, p.jyy1, p.jzz1]), ...
          link(0, "R", turn, [p.l1, 0, 0], p.m2, p.c2, [p.jxx2, p.jyy2, p.jzz2]), ...
          link(-1, "P", [0, 0, 1, 1, 0, 0, 0, 1, 0], [0, 0, 0], p.m3, 0, ...
               [p.jxx3, p.jyy3, p.jzz3]), sprintf("%.17g\n", p.l2)];
end
