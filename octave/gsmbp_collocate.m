## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {@var{r} =} gsmbp_collocate (@var{m}, @var{x0}, @var{xf}, @var{option}, @
## @var{value}, @dots{})
## An optimal motion of the model @var{m} from the states @var{x0} to @var{xf}, by direct
## collocation.
##
## @var{x0}, @var{xf}: @var{nx} numbers each, NaN where a state is free.  In a closed chain the
## dependent coordinates and speeds at the end follow: numbers there are a guess.  The scene is
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
## Hamiltonian.  To the accuracy of the states between intervals, with "radau" to a lower
## order within them
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
  o.ends = time () + {o.timeout, Inf}{1 + (o.timeout == 0)};
  [s, found] = refined (who, m, p, o);
  found.singular = rmfield (found.singular(! [found.singular.held]), "held");
  r = gs.collocation.motion_result (m, s, found);
  r.solved = s.solved && s.error <= o.accuracy;
  r.stopped = s.stopped;
  gs.run.stopped_word (who, m, 9 * strcmp (s.stopped, "interrupted"), "", false);
  if (! isempty (s.stopped))
    r.ended = [gs.run.stopped_text(s.stopped) s.how_far];
  elseif (s.solved && ! r.solved)
    r.ended = sprintf (["stopped at the limit of %d refinements: the estimated error of the " ...
                        "states is %.2g"], o.refinements, s.error);
  endif
  r.ended = [r.ended, told(r.singular)];
  if (! r.solved)
    warning ("gsmbp:collocation", "%s: %s: %s%s", who, m.name, r.ended, worst (m, s));
  endif
endfunction

## solved on finer and finer meshes; jumps and singular arcs
function [s, r] = refined (who, m, p, o)
  r = struct ("active", [], "meshes", [], "switches", zeros (0, 1), "singular", ...
              gs.collocation.find_singular (m, p, []));
  n = o.intervals;
  mesh = struct ("rule", gs.collocation.quadrature_rule (o.method), ...
                 "breaks", [ones(1, n); (0:n-1) / n; (1:n) / n]);
  guess = gs.collocation.first_guess (who, m, p, o.guess);
  before = [];
  for k = 0:o.refinements
    [cut, s, errors, q, found] = m.module ("guarded", @() meshed (who, m, p, mesh, guess, o, r), ...
                                           o.ends - time () + 0.2);
    if (cut || ! isempty (s.stopped))
      [s, r] = so_far (who, m, s, before, cut, r, found);
      break;
    endif
    [p, r] = deal (q, found);
    if (! isempty (r.switches) || ! s.solved || s.error <= o.accuracy)
      break;
    endif
    mesh = gs.collocation.finer_mesh (mesh, errors, o.accuracy);
    guess = before = s;
  endfor
endfunction

## solved on a mesh, with what jumps or is singular there
function [s, errors, p, r] = meshed (who, m, p, mesh, guess, o, r)
  [s, errors, r] = one_mesh (who, m, p, mesh, guess, o, r);
  if (! isempty (s.stopped))
    return;
  endif
  [polished, r.switches] = gs.collocation.polish_switches (who, m, p, s, o);
  if (! isempty (r.switches))
    s = polished;
    r.meshes = [r.meshes, mesh_of(s)];
  elseif (isempty (polished.stopped))
    [s, errors, p, r] = smoothed (who, m, p, mesh, s, errors, o, r);
  else
    s.stopped = polished.stopped;
  endif
endfunction

function [s, errors, r] = one_mesh (who, m, p, mesh, guess, o, r)
  s = gs.collocation.solve_mesh (who, m, p, mesh, guess, o);
  errors = [];
  if (! isempty (s.stopped) && ! isempty (r.meshes))   # the mesh before is given back
    return;
  endif
  [s.error, errors] = gs.collocation.mesh_errors (m, s);
  r.active = gs.collocation.active_limits (m, p, s);
  r.meshes = [r.meshes, mesh_of(s)];
endfunction

## what is given back where the search was ended from outside: the mesh BEFORE, if any
function [s, r] = so_far (who, m, s, before, cut, r, found)
  word = {"interrupted", "timeout"}{max (1, cut)};
  if (! cut)
    word = s.stopped;
  endif
  if (! isempty (before))
    s = setfield (before, "how_far", sprintf ("; solved on %d intervals, with an error of %.2g", ...
                                              columns (before.c.left), before.error));
  elseif (cut)
    error ("gsmbp:stopped", "%s: %s: %s before there was a solution", who, m.name, ...
           gs.run.stopped_text (word));
  else
    s.how_far = " on the first mesh";
    r = found;
  endif
  s.solved = false;
  s.stopped = word;
endfunction

function one = mesh_of (s)
  one = struct ("intervals", columns (s.c.left), "iterations", s.iterations, ...
                "error", s.error, "ended", s.ended);
endfunction

## singular arcs: solved again where the inputs there were not yet made smooth
function [s, errors, p, r] = smoothed (who, m, p, mesh, s, errors, o, r)
  again = ! isfield (p, "singular");
  r.singular = gs.collocation.find_singular (m, p, s);
  p.singular = gs.collocation.singular_arcs (p, s, r.singular, o.regularize);
  if (isempty (p.singular))
    p = rmfield (p, "singular");
    return;
  endif
  for k = 1:numel (p.singular)
    r.singular(k).weight = p.singular(k).weight;
  endfor
  if (again && o.regularize > 0)
    [new, errors_, r] = one_mesh (who, m, p, mesh, s, o, r);
    if (new.solved)
      s = new;
      errors = errors_;
    endif
    s.stopped = new.stopped;
  endif
endfunction

function text = told (arcs)
  text = "";
  for one = arcs
    text = sprintf ("%s; %s is singular from %.4g to %.4g s", text, one.name, one.from, one.until);
    if (one.weight > 0)
      text = [text, " (made smooth there)"];
    endif
  endfor
endfunction

## what an equation that does not hold says, where none was solved
function text = worst (m, s)
  text = "";
  if (s.solved)
    return;
  endif
  [most, k] = max (max (s.c.glow - s.g, s.g - s.c.ghigh));
  if (most > 1e-6)
    text = sprintf ("; the equations miss by %.2g at most (%s)", most, named (m, s.c, k));
  endif
endfunction

function name = named (m, c, k)
  [i, j] = find (c.residual == k, 1);
  if (! isempty (i))
    names = [strcat({"the equation of motion of "}, m.speeds(:)); ...
             strcat({"loop "}, m.multipliers(:))];
    name = names{i};
    return;
  endif
  [i, j] = find (c.path == k, 1);
  if (! isempty (i))
    name = ["output " m.outputs{c.bounded(i)-c.output}];
    return;
  endif
  i = mod (k - c.defect(1), c.d.nx) + 1;
  name = ["state " m.states{i}];
endfunction

%!error <DAE, DAJ, DAH>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! gsmbp_collocate (gsmbp_hand ("motor_pendulum"), zeros (3, 1), zeros (3, 1), "time", 1);
