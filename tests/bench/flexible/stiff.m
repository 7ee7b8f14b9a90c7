## stiff.m OUT: what a fast mode costs, by the explicit and by the implicit method, and what becomes
## of the tip where modes are dropped; called by `make bench-flexible`; prints a table for
## flexible.md. Runs of 1 s of stiff.mac; the error is that of the tip against all modes at a
## tolerance of 1e-11; times alternate, the least of 25 counts.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (fileparts (here)));
addpath (fullfile (root, "octave"), fullfile (root, "octave", "hand"));
cd (argv (){end});
warning ("off", "all");

function m = with_modes (here, k, words)
  own = sprintf ("\"stiff_%d\"", k);
  text = strrep (fileread (fullfile (here, "stiff.mac")), "\"stiff\"", own);
  if (isempty (strfind (words, "stretch")))
    text = strrep (text, "EA = 15.6e6*N, ", "");
  end
  f = fopen (sprintf ("stiff_%d.mac", k), "w");
  fputs (f, strrep (text, "modes = [4, 1], stretch = EA", words));
  fclose (f);
  gsmbp_derive (sprintf ("stiff_%d.mac", k), pwd ());
  m = gsmbp_build (sprintf ("stiff_%d", k), "directory", pwd ());
end

function y = tip (m, r)
  y = cell2mat (cellfun (@(x) m.out (0, x)(1:2), num2cell (r.x, 2)', "UniformOutput", false));
end

words = {"modes = [4, 1], stretch = EA", "modes = 4", "modes = 3", "modes = 2", "modes = 1"};
names = {"4 of bending, 1 of stretch", "4 of bending", "3", "2", "1"};
for k = 1:5
  m{k} = with_modes (here, k, words{k});
end
## model, damping ratio, method, tolerance
cases = {1, 0.005, "dp853", 1e-4; 1, 0.005, "cvode", 1e-3; 1, 0.005, "cvode", 1e-4
         1, 0.05, "dp853", 1e-4; 1, 0.05, "cvode", 1e-4
         2, 0.005, "dp853", 1e-4; 2, 0.005, "cvode", 1e-4; 3, 0.005, "dp853", 1e-4
         4, 0.005, "dp853", 1e-4; 5, 0.005, "dp853", 1e-4};
t = linspace (0, 1, 101);
run = @(m, method, tol) gsmbp_simulate (m, m.initial, t, "method", method, "rtol", tol, ...
                                        "atol", tol);
for zeta = [0.005, 0.05]
  whole = gsmbp_set (m{1}, "zeta", zeta);
  r = gsmbp_simulate (whole, whole.initial, t, "rtol", 1e-11, "atol", 1e-13);
  exact.(sprintf ("z%d", 1000 * zeta)) = tip (whole, r);
end
least = Inf (rows (cases), 1);
for pass = 1:25
  for c = 1:rows (cases)
    [k, zeta, method, tol] = cases{c,:};
    n = gsmbp_set (m{k}, "zeta", zeta);
    r = run (n, method, tol);
    least(c) = min (least(c), r.stats.seconds);
    calls(c) = r.stats.calls;
    off(c) = max (abs (tip (n, r) - exact.(sprintf ("z%d", 1000 * zeta)))(:));
  end
end
puts (["\n# A fast mode\n\nAn arm of 1 m with a load, 1 s; frequencies of bending 27 to 480 " ...
       "rad/s, of stretch 5660 rad/s.\n\n" ...
       "| modes | damping ratio | method | tolerance | calls | ms | error of the tip [m] |\n" ...
       "|---|---|---|---|---|---|---|\n"]);
for c = 1:rows (cases)
  printf ("| %s | %g | %s | %g | %d | %.2f | %.1e |\n", names{cases{c,1}}, cases{c,2:4}, ...
          calls(c), 1e3 * least(c), off(c));
end
