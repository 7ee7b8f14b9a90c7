## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {@var{r} =} gsmbp_collocate (@var{m}, @var{x0}, @var{xf}, @var{option}, @
## @var{value}, @dots{})
## An optimal motion of the model @var{m} from the states @var{x0} to @var{xf}, by direct
## collocation.
##
## @var{x0}, @var{xf}: @var{nx} numbers each, NaN where a state is free.  In a closed chain
## dependent coordinates and speeds follow the actuated ones: they may be NaN in @var{x0}; numbers
## of @var{xf} are a guess, unless an actuated coordinate (or speed) is free there: then all are
## demanded.  The scene is
## derived with the request @code{collocation}, whose straight-line code gives sparse exact
## derivatives of first and second order; Ipopt solves.
##
## Options:
## @table @code
## @item "time"
## the duration [s]: a number, or the least and the largest
## @item "goal"
## what is least: @code{"time"}, the name of an output, state or input, whose integral is meant,
## @code{"NAME^2"} or @code{"NAME*NAME"}, that of a square or product of states and inputs,
## @code{"final NAME"}, a state or an output at the end, or such words and their weights,
## @code{@{"time", 1, "F^2", 0.1, "final height", -2@}}; default @code{"time"}
## @item "final"
## bounds of states at the end, rows @code{@{name, least, largest@}}
## @item "inputs", "states", "outputs"
## bounds on the way, a row @code{@{name, least, largest@}} for each; inputs and coordinates have
## the limits of the scene by default
## @item "parameters"
## parameters of the scene that are free, too, rows @code{@{name, least, largest@}}; the scene is
## derived with @code{sensitivity(name, @dots{})} beside @code{collocation}
## @item "method"
## @code{"radau"} (Radau IIA, order 5; default) or @code{"lobatto"} (Hermite and Simpson, order 4,
## inputs without jumps)
## @item "intervals", "accuracy", "refinements"
## intervals at first (20); the estimated error of the states, relative to their largest value or 1,
## above which intervals are cut (1e-6), so often at most (6)
## @item "guess"
## a former result, or a struct with t, x, v (a row for each time)
## @item "polish"
## where inputs jump between their limits, solve once more with the instants of these jumps as
## unknowns (default true)
## @item "regularize"
## on singular arcs, where the goal does not determine an input by itself and it chatters, the
## weight of its roughness (1); 0: such arcs are told only
## @item "tolerance", "iterations", "seconds"
## of Ipopt: 1e-9, 500 and 60 for each mesh
## @item "timeout"
## of all meshes together [s]; 0, the default: none
## @end table
##
## The result:
## @table @code
## @item t, x, v, ud, lambda, y
## a row for each point of the collocation: times [s], states, inputs, accelerations, multipliers,
## outputs
## @item costates
## the derivatives of the least value by the states, a row for each point: lambda of the minimum
## principle, where the goal's integrand and lambda' * (rates of the states) make the
## Hamiltonian.  With "radau" to the accuracy of the states between intervals, to a lower order
## within them; with "lobatto" to some square root of it
## @item goal, T, parameters
## the least value, the duration, the free parameters by name
## @item input, motion
## the inputs as a piecewise polynomial, as @code{gsmbp_simulate} takes it ([] for a scene without
## inputs), and the coordinates that @code{gsmbp_inverse} takes as a planned motion ([] where the
## speeds are not their rates)
## @item error, meshes
## the estimated error of the states; of each mesh its intervals, iterations and error
## @item active
## the bounds that hold the goal back: name, which, from and until when, the integral of its
## multiplier (what the goal gains by a unit of the bound)
## @item switches
## where it was polished the times at which inputs jump [s]
## @item singular
## arcs where an input is between its limits without being bent by the Hamiltonian: input, name,
## from, until [s], ringing (the largest distance from a smooth curve), weight (of its roughness)
## @item solved, ended
## whether it is a solution, within the accuracy, and why it ended
## @item stopped
## "interrupted" by Ctrl-C or "timeout": what is given back is the last mesh that was solved, or on
## the first one where Ipopt stood; else ""
## @end table
##
## A motion that cannot be is no error: @code{solved} is false, a warning says why.
##
## @c session octave
## @example
## >> file = fopen ("block.mac", "w");
## >> fputs (file, "scene : gsmbp_scene(\"block\", link(body, mass = m), ");
## >> fputs (file, "prismatic(rail, ground, body, axis = x, coordinate = s), ");
## >> fputs (file, "input(F, unit = N), force(push, body, vector = [F, 0, 0]), ");
## >> fputs (file, "output(effort, F^2), parameters = [m = 1*kg])$ ");
## >> fputs (file, "requests : '[all, collocation]$");
## >> fclose (file);
## >> gsmbp_derive ("block.mac", "fortran_out");
## ...
## >> m = gsmbp_build ("block");
## >> r = gsmbp_collocate (m, [0 0], [1 0], "goal", "effort", "time", 1);
## >> round (1e4 * [r.goal, r.v([1 end])']) / 1e4
## ans =
##
##    12    6   -6
## @end example
##
## Errors: states of another size; an unknown name; bounds in the wrong order; a scene with events
## or sampled devices; a missing subroutine; Ipopt is not installed.
## Source: Betts, Practical Methods for Optimal Control and Estimation, 2010; Kelly, SIAM Review
## 59(4), 2017 (Hermite and Simpson).
## @seealso{gsmbp_optimize, gsmbp_inverse, gsmbp_simulate}
## @end deftypefn

function r = gsmbp_collocate (m, x0, xf, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_collocate";
  gs.given.check_model (who, m);
  gs.given.refuse_words (who, "x0", x0, "xf", xf);
  [p, o] = gs.collocation.read_problem (who, m, x0, xf, varargin);
  guess = gs.collocation.read_guess (who, m, o.guess);
  library = gs.model.host_library (who, m, "ipopt");
  r = m.module ("collocate", m.cst, gs.model.parameter_values (m), p, library, o, guess);
  r = named (m, p, r);
  gs.run.stopped_word (who, m, 9 * strcmp (r.stopped, "interrupted"), "", false);
  if (! r.solved)
    warning ("gsmbp:collocation", "%s: %s: %s", who, m.name, r.ended);
  endif
endfunction

## with names and piecewise polynomials instead of numbers
function r = named (m, p, r)
  free = {p.parameters.name};
  names = struct ("state", {m.states}, "input", {m.inputs}, "output", {m.outputs}, ...
                  "time", {repmat({"time"}, 1, rows (r.t))}, "parameter", {free});
  list = struct ("name", {}, "bound", {}, "value", {}, "from", {}, "until", {}, "multiplier", {});
  for one = r.active
    list(end+1) = struct ("name", names.(one.of){one.number}, "bound", one.bound, "value", ...
                          one.value, "from", one.from, "until", one.until, "multiplier", ...
                          one.multiplier);
  endfor
  r.active = list;
  arcs = struct ("input", {}, "name", {}, "from", {}, "until", {}, "ringing", {}, "weight", {});
  for one = r.singular
    arcs(end+1) = struct ("input", one.input, "name", m.inputs{one.input}, "from", one.from, ...
                          "until", one.until, "ringing", one.ringing, "weight", one.weight);
  endfor
  r.singular = arcs;
  r.parameters = cell2struct (num2cell (r.unknown(:)), free(:), 1);
  r.input = piecewise (r.breaks, r.input, m.sizes.nv);
  r.motion = piecewise (r.t', r.motion, r.planned);
  r = rmfield (r, {"unknown", "breaks", "planned"});
endfunction

## a piecewise polynomial of N quantities, [] where there are none
function pp = piecewise (breaks, coefficients, n)
  pp = [];
  if (n > 0)
    pp = mkpp (breaks, reshape (coefficients, n, numel (breaks) - 1, []), n);
  endif
endfunction

%!error <DAE, DAJ, DAH>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! gsmbp_collocate (gsmbp_hand ("motor_pendulum"), zeros (3, 1), zeros (3, 1), "time", 1);
