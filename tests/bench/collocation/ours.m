## ours (root, out, sizes): the swing-up of tests/scenes/optimal_cart.mac by Hermite and Simpson:
## for each number of intervals a line `N, ms to set up, ms for one evaluation of all derivatives,
## iterations, goal`, as casadi_nlp.py prints them.

function ours (root, out, sizes)
  addpath (fullfile (root, "octave"));
  gsmbp_derive (fullfile (root, "tests", "scenes", "optimal_cart.mac"), out);
  m = gsmbp_build ("optimal_cart", "directory", out);
  asked = {"goal", "effort", "time", 2, "states", {"p", -2, 2}, "method", "lobatto"};
  for n = sizes
    [p, o] = gs.collocation.read_problem ("ours", m, zeros (1, 4), [1 pi 0 0], asked);
    mesh = struct ("rule", gs.collocation.quadrature_rule ("lobatto"), ...
                   "breaks", [ones(1, n); (0:n-1) / n; (1:n) / n]);
    guess = gs.collocation.first_guess ("ours", m, p, []);
    [setup, f, c] = set_up (m, p, mesh);
    seconds = evaluation (f, c);
    s = gs.collocation.solve_mesh ("ours", m, p, mesh, guess, o);
    printf ("%d %.3f %.4f %d %.14g\n", n, 1e3 * setup, 1e3 * seconds, rows (s.log) - 1, s.J);
  end
end

function [least, f, c] = set_up (m, p, mesh)
  least = Inf;
  for k = 1:5
    begin = tic ();
    c = gs.collocation.make_program (m, p, mesh);
    f = c.program;
    f ("places");
    least = min (least, toc (begin));
  end
end

## goal, gradient, equations, Jacobian and Hessian at points that are new, as Ipopt calls them
function least = evaluation (f, c)
  least = f ("time", 0.1 * ones (c.n, 1), 1, 0.3 * ones (c.m, 1));
end
