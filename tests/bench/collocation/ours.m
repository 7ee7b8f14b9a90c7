## ours (root, out, sizes): the swing-up of tests/scenes/optimal_cart.mac by Hermite and Simpson,
## for each number of intervals a line `N, ms to set up, ms for one evaluation of all derivatives,
## ms of processor time of a whole call, iterations, goal`, as casadi_nlp.py prints them.

function ours (root, out, sizes)
  addpath (fullfile (root, "octave"));
  gsmbp_derive (fullfile (root, "tests", "scenes", "optimal_cart.mac"), out);
  m = gsmbp_build ("optimal_cart", "directory", out);
  asked = {"goal", "effort", "time", 2, "states", {"p", -2, 2}, "method", "lobatto"};
  for n = sizes
    [p, o] = gs.collocation.read_problem ("ours", m, zeros (1, 4), [1 pi 0 0], asked);
    breaks = [ones(1, n); (0:n-1) / n; (1:n) / n];
    part = @(varargin) m.module ("program", m.cst, gs.model.parameter_values (m), p, 1, breaks, ...
                                 varargin{:});
    setup = Inf;
    for k = 1:5
      begin = tic ();
      [unknowns, equations] = part (-1);
      setup = min (setup, toc (begin));
    end
    seconds = part (-2, 0.1 * ones (unknowns, 1), 1, 0.3 * ones (equations, 1));
    whole = Inf;
    for k = 1:5
      begin = cputime ();
      r = gsmbp_collocate (m, zeros (1, 4), [1 pi 0 0], asked{:}, "intervals", n, ...
                           "refinements", 0);
      whole = min (whole, cputime () - begin);
    end
    printf ("%d %.3f %.4f %.1f %d %.14g\n", n, 1e3 * setup, 1e3 * seconds, 1e3 * whole, ...
            r.meshes(1).iterations, r.goal);
  end
end
