## r = gs.run.run_ipopt (who, folder, p, o)
## A problem solved by Ipopt (glue/gsmbp_ipopt.cc, built in FOLDER where it is missing or old).
## P: a struct with x0, low, high; glow, ghigh (of the constraints); jac, hess (places of the
## entries, two columns; hess []: Ipopt's own by limited memory); f (what, x, factor, lambda), or
## the address of a program in a module.  O: tolerance, iterations, evaluations, seconds, and
## options, more words of Ipopt with their values. R: x, J, g, lambda, zl, zu, status (of Ipopt),
## ended (a sentence), solved, limit, log, text, interrupted.

function r = run_ipopt (who, folder, p, o)
  persistent loaded = "";
  file = glue (who, folder);
  if (! strcmp (loaded, file))
    gs.files.load_module ("gsmbp_ipopt_solve", file, []);
    loaded = file;
  endif
  way = {};
  if (isempty (p.hess))
    way = {"hessian_approximation", "limited-memory"};
  endif
  options = [{"print_level", int32(0), "sb", "yes", "tol", o.tolerance, ...
              "max_iter", int32(o.iterations), "acceptable_tol", 1e-7, "acceptable_iter", ...
                  int32(8), ...
              "bound_relax_factor", 1e-10}, way, o.options];
  [r.x, r.status, r.J, r.g, r.lambda, r.zl, r.zu, r.log, r.text, r.interrupted] = ...
      gsmbp_ipopt_solve (p.x0, p.low, p.high, p.glow, p.ghigh, p.jac, p.hess, p.f, options, ...
                         o.evaluations, o.seconds);
  r.solved = any (r.status == [0, 1, 6]) && ! r.interrupted;
  r.limit = any (r.status == [5, -1, -4]) || r.interrupted;
  r.ended = sentence (r.status, o);
  if (r.interrupted)
    r.ended = gs.run.stopped_text ("interrupted");
  endif
  r.infeasible = r.status == 2;
endfunction

function text = sentence (status, o)
  table = {0, "solved"; 1, "solved to an acceptable level"; 6, "a feasible point was found"
           2, "no point that fulfils the constraints was found"
           3, "the steps became too small"; 4, "the iterates diverge"
           5, sprintf("stopped at the limit of %g evaluations or %g s", o.evaluations, o.seconds)
           -1, sprintf("stopped at the limit of %d iterations", o.iterations)
           -2, "the search for a feasible point failed"; -3, "no step could be computed"
           -10, "more equations than unknowns"; -13, "a value was no finite number"};
  k = find ([table{:,1}] == status);
  text = sprintf ("Ipopt ended with %d", status);
  if (! isempty (k))
    text = table{k,2};
  endif
endfunction

## the module, built where it is missing or made of other texts
function file = glue (who, folder)
  file = fullfile (folder, "gsmbp_ipopt_solve.oct");
  sources = cellfun (@(f) gs.files.own_place ("octave", "glue", f), ...
                     {"gsmbp_ipopt.cc"; "gsmbp_program.h"; "header_ipopt.h"}, ...
                     "UniformOutput", false);
  gs.files.build_once (who, file, OCTAVE_VERSION (), sources, ...
                       @(place) compile (who, sources{1}, place));
endfunction

function new = compile (who, source, place)
  quote = @(text) ["'" strrep(text, "'", "'\\''") "'"];
  new = "new.oct";
  [~, found] = gs.files.find_header ("ipopt");
  if (! found)
    error ("%s: Ipopt is not installed (Debian: coinor-libipopt-dev)", who);
  endif
  gs.files.run_command (who, sprintf ("cd %s && mkoctfile -g0 -o new.oct %s -lipopt", ...
                                      quote (place), quote (source)));
endfunction
