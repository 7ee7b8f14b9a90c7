## -*- texinfo -*-
## @c category Models
## @deftypefn  {} {@var{m} =} gsmbp_build (@var{name})
## @deftypefnx {} {@var{m} =} gsmbp_build (@var{name}, @var{option}, @var{value}, @dots{})
## Compile the emitted Fortran of a scene and return its model.
##
## @file{fortran_out/@var{name}.json} says what there is,
## @file{fortran_out/@var{name}.f} is compiled together with the run time of
## @file{share/fortran} into a module under @file{fortran_out/build}; what was
## built from the same texts is used as it is.  Two builds at once wait for each other.
## The run time is compiled once for each user and kept in the cache folder
## (@file{~/.cache/gsmbp}; @code{GSMBP_CACHE}).
##
## @var{m} is a struct.  Its handles call the emitted subroutines; vectors are
## columns (rows are taken too), units are SI, every argument is checked for
## size and finiteness:
## @table @code
## @item qdot = m.kin (t, q, u)
## rates of the @var{nq} coordinates from the @var{nu} speeds
## @item tau = m.inv (t, q, u, ud[, v])
## inverse dynamics of the tree, @var{nu} efforts
## @item M = m.mas (t, q), b = m.bia (t, q, u[, v])
## mass matrix and bias: tau = M*ud + b
## @item [Y, p, r] = m.reg (t, q, u, ud[, v])
## regressor: tau = Y*p + r, @var{p} the base parameters
## (@code{m.json.base_parameters}); emitted where @code{regressor} is requested
## @item [q, u, ud, tau(, lam), info] = m.inq (t, q, u, ud[, v])
## inverse dynamics with the modal coordinates of flexible links in quasi-static balance; emitted
## where @code{static_modes} is requested; lam in closed chains
## @item [ud, info] = m.fwd (t, q, u, v, tau)
## accelerations of the tree
## @item [phi, phit, H, gam, info] = m.con (t, q[, u])
## constraints: H*u + phit = 0, H*ud = gam
## @item [tau, lam, info] = m.inl (t, q, u, ud[, v])
## inverse dynamics with loops: efforts of the actuated coordinates, multipliers
## @item [M, B, C] = m.lin (t, q, u, ud[, v])
## linear model about a motion of the tree
## @item [xd, info] = m.rhs (t, x[, v])
## state space of the whole scene
## @item m.inv_v, m.mas_v, m.bia_v, m.fwd_v, m.rhs_v
## the same as inv, mas, bia, fwd, rhs with a column for each of @var{K} states
## in every argument and result (mas_v: @var{nu} x @var{nu} x @var{K}, @var{info}:
## 1 x @var{K}, @var{t}: 1 x @var{K}); @var{t}, @var{v} and others given as one
## column are the same for all states.  Emitted by the requests
## @code{[all, batch]} of @code{gsmbp_fortran}, vectorized.  A state that is no
## number has its own @var{info} < 0 and NaN as its results
## @item [ud, lam, info] = m.acc (t, x[, v])
## accelerations and multipliers of a closed chain
## @item [ud, lam, info] = m.acd (t, x, v, way)
## the same by one of the ways of solution: 1 multipliers, 2 null space,
## 3 zero-eigenvalue theorem, 4 Kane with dependent speeds
## @item [P, R] = m.tan (t, x)
## derivatives of the constraints and of their rates by the coordinates,
## @var{nlam} x @var{nq}
## @item [x, res, info] = m.prj (t, x)
## the state moved onto the constraints, residual before
## @item [A, B, C, D, info] = m.jac (t, x[, v])
## exact Jacobians
## @item [P, A, B, xd, info] = m.rhp (t, x[, v])
## derivatives of the rates of the states by the parameters @code{m.json.sensitivity}, by states and
## inputs, and these rates (request @code{sensitivity})
## @item [Lx, Lv, Lp, info] = m.adj (t, x, v, L)
## derivatives of L'*xd by states, inputs and these parameters, backwards (request @code{adjoint})
## @item P = m.inp (t, q, u, ud[, v])
## derivatives of the efforts of m.inv by these parameters
## @item D = m.ilp (t, q, u, ud, v, taua, lam)
## derivatives of what vanishes along a motion of a closed chain, the rows of m.inl, constraints,
## their first and second rates, by q, u, ud, [taua; lam] and these parameters
## @item [P, info] = m.oup (t, x[, v])
## derivatives of the outputs by them, at a given state
## @item [P, R] = m.cop (t, x)
## derivatives of the constraints and of their rates by them
## @item [y, info] = m.out (t, x[, v])
## outputs
## @item [v, xid, info] = m.cmd (t, qj[, xi])
## @item [v, xid, xa, margins, info] = m.cmx (t, qj[, xi])
## inputs for a motion; @var{qj} is @var{nu} x (1 + command order)
## @item [Vx, Vp, info] = m.cmp (t, qj[, xi])
## derivatives of these inputs by states of the devices and by the parameters
## @code{m.json.sensitivity} (request @code{sensitivity})
## @item [Vj, Xj, info] = m.cmj (t, qj[, xi])
## derivatives of these inputs, and of the states of the devices along the motion, by the
## coordinates that are planned, their derivatives in turn, and the parameters (request
## @code{sensitivity})
## @item [v, xk] = m.ctl (k, t, y, xk, v)
## one sample of device @var{k} of @code{m.controllers} (0: of all in their order):
## held outputs in the inputs @var{v} and memory @var{xk} after it, @var{y} from m.out
## @item g = m.evt (t, x, v, mode)
## event functions of @code{m.events}, above 0 where nothing happens
## @item [row, s, sd, prm] = m.hld (t, x[, v])
## their ports: rows of their speeds, positions, speeds, and numbers in 4 rows (a stop's: lower end,
## upper end, restitution, speed below which it rests)
## @item [x, mode, v, info] = m.rst (t, x, v, mode, k)
## what happens at event @var{k}; 0: the modes that belong to a state; -1: what sticks
## comes to rest
## @item [qj, res, info] = m.clo (t, qj)
## completes the motion of a closed chain
## @item e = m.ene (t, x[, v])
## kinetic, potential, stored energy [J]; power in, power dissipated [W]
## @item [g, s] = m.mar (t, x[, v])
## margins of the devices (@code{m.state_margins}: strokes, pressures), above 0 where
## their laws hold, and the sizes of these numbers (of their terms)
## @item ts = m.swi ()
## the times at which the scene switches [s]
## @item [P, R] = m.pnt (t, q)
## places of the points and frames of the scene (@code{m.points}) in ground axes [m],
## 3 x @var{np}, and their axes side by side, 3 x 3@var{np} (@code{gsmbp_point} by name)
## @item [J, dJu] = m.jpt (t, q, u)
## their Jacobians in ground axes side by side, 6 x @var{nu}*@var{np}, rows vx, vy, vz of the
## point, wx, wy, wz; and (dJ/dt)*u, 6 x @var{np}; m.pnt_v, m.jpt_v for many states
## @item [P, R, J] = m.pnj (t, q)
## places, axes and Jacobians in one call (request @code{pose_jacobians})
## @item [P, R, J, dJu] = m.pnr (t, q, u)
## the same with (dJ/dt)*u (request @code{pose_rates})
## @item g = m.gra (t, q), n = m.cor (t, q, u)
## gravity, and Coriolis and centripetal efforts, parts of the bias (requests @code{gravity},
## @code{coriolis})
## @item [T, c, u0, info] = m.ind (t, q, u)
## motion of a closed chain by independent speeds w: u = T*w + u0, ud = T*wd + c (request
## @code{independent})
## @item [M, b, g, info] = m.red (t, q, u[, v])
## its mass matrix, bias and gravity by w (request @code{reduced})
## @item [J, a, info] = m.jpi (t, q, u)
## Jacobians of the points by w, and their accelerations at wd = 0 (request
## @code{independent_jacobians})
## @item P = m.ske (t, q)
## points of the skeletal diagram in ground axes [m], 3 x @var{np}, body by
## body, then ends of springs, dampers and devices between two points, of discs that roll centre, a
## point of the axis, a point of the rim (@code{m.skeleton})
## @end table
## A handle whose subroutine was not emitted (@code{m.subroutines} names those that
## were) is an error that names the request.  Where @var{info} is not taken,
## @var{info} != 0 is an error (lost rank of constraints, 2, a warning; none where
## constraints are redundant everywhere, which @code{gsmbp_mobility} lists).
##
## Other fields: @code{gsmbp_version} and @code{scene_hash} (the version of GSMBP that
## emitted the scene, and a hash of what was written in it; "" where the JSON has none),
## @code{par} (parameter values, to read; @code{gsmbp_set} changes them), @code{coordinates},
## @code{speeds}, @code{states},
## @code{inputs}, @code{outputs}, @code{multipliers}, @code{points} (names), @code{unique} (a struct
## with @code{multipliers}, @code{outputs}: which of them the motion determines, the
## others are one of many values and depend on where a loop is cut), @code{units} (a
## struct with the same fields), @code{sizes}, @code{actuated},
## @code{initial} (the start that the scene states: coordinates, a guess where there are
## loops; speeds zero; states of devices, filters of sensors and observers settled), @code{nominal}
## (the usual size of each state in its unit), @code{json},
## @code{skeleton} (a struct of columns, a row for each body, ground first:
## @code{body}, its name; @code{points}, how many columns of m.ske are its; and
## @code{joints}, how many of these, the first ones, are where joints stand: a
## point behind them is the mass centre; @code{parts}, a struct array of what stands
## behind the bodies: @code{name}, @code{kind}, @code{bodies}, one for each column), @code{removed}
## (constraint rows that were left out: a struct array with @code{row} and @code{reason}),
## @code{mobility} (a struct: Gruebler's count and what it is made of),
## @code{sources} (the files of the Fortran: the scene's, that of option "input" or ""),
## @code{orientation} (a row of four numbers of coordinates for each set of
## Euler parameters), @code{angles} (joints whose orientation is in angles),
## @code{speed_rows} (numbers of the constraints on speeds alone),
## @code{internal} (numbers of the states that the inverse of the devices
## integrates), @code{margins} (what must be above 0 for a command), @code{state_margins} (what
## must be above 0 in a state),
## @code{controllers} (the sampled devices, a struct array: @code{name},
## @code{entry}, @code{period} and @code{delay} (a number or an expression in
## parameters), @code{memory} (names), @code{starts}, @code{possible} (what a memory
## must keep to), @code{outputs} (numbers of the
## inputs that they hold), @code{reads} (numbers of the outputs that they read)),
## @code{events} (ports that stick or hit stops, a struct array: @code{name},
## @code{entry}, @code{kind} ("stick", "stop"), @code{input}, the number of the input
## that is the mode: 1, -1, 0).
##
## Options:
## @table @code
## @item "parameters"
## a struct of parameter values that differ from the scene's
## @item "precision"
## "double" (default) or "quad": the same Fortran in quad precision, called
## with doubles and returning doubles
## @item "directory"
## where the .f and .json are (default: @file{fortran_out} of the working directory,
## or of the repository if the scene's Fortran is there alone)
## @item "build"
## where the modules go (default: @file{build} in that directory; where one must not
## write there, @file{fortran_out/build} of the working directory)
## @item "input"
## a Fortran file with SUBROUTINE GSVIN( T, SIDE, X, NX, NV, IP, RP, CST, V, INFO ), used by
## @code{gsmbp_simulate} with input @code{"user"}: the inputs V(NV) at the time T [s] (SIDE < 0: the
## limit from the left, where they jump) and the states X(NX). CST are the constants of PRE; IP and
## RP belong to the run. A run ends where INFO is not 0
## @item "controller"
## a controller with a period (@code{gsmbp_control}, @code{gsmbp_pid}), or a cell array of them: the
## machine with it as a further sampled device, which reads outputs of the scene and holds inputs.
## Its Fortran is that of @code{gsmbp_controller}; its references are inputs behind those of the
## scene, and at the trim where nothing else is said.  A run starts with its memory at the trim.
## Option "sensitivity" of @code{gsmbp_simulate} goes through it where the scene has no sampled
## devices of its own and the controller does not round
## @end table
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> m.coordinates'
## ans =
## @{
##   [1,1] = q1
##   [1,2] = q2
##   [1,3] = q3
## @}
## >> tau = m.inv (0, [0.5; -0.7; 0.6], [1; -1; 0.1], [0; 0; 0])
## tau =
##
##    7.7580
##    3.5571
##         0
## >> M = m.mas (0, [0.5; -0.7; 0.6])
## M =
##
##    0.3997   0.1824        0
##    0.1824   0.1250        0
##         0        0   1.0000
## @end example
##
## Errors: a .json or .f that is missing, cut short or of another emission; a
## compiler that fails (what it says is shown); an unknown option or
## parameter, a value that the scene refuses; a handle called with an argument
## of the wrong size, one that is not finite, or without its subroutine.
## Source: own; every subroutine names its method in its head.
## @seealso{gsmbp_set, gsmbp_simulate, gsmbp_inverse, gsmbp_linear, gsmbp_animate}
## @end deftypefn

function m = gsmbp_build (name, varargin)
  if (nargin < 1 || ! ischar (name))
    print_usage ();
  endif
  table = {"parameters", struct(), "any"
           "precision", "double", {"double", "quad"}
           "directory", default_directory(name), "text"
           "build", "", "text"
           "input", "", "text"
           "controller", [], "any"};
  options = gs.given.call_options ("gsmbp_build", table, varargin);
  if (! (isstruct (options.parameters) && isscalar (options.parameters)))
    error (["gsmbp_build: option parameters: expected a struct of names and values, " ...
            "found %s"], gs.text.shown_value (options.parameters));
  endif
  folder = make_absolute_filename (options.directory);
  source = fullfile (folder, [name ".f"]);
  description = fullfile (folder, [name ".json"]);
  input = options.input;
  if (! isempty (input))
    input = make_absolute_filename (input);
    if (exist (input, "file") != 2)
      error ("gsmbp_build: there is no input file %s", input);
    endif
  endif
  build = options.build;
  if (isempty (build))
    build = default_build (folder);
  endif
  build = make_absolute_filename (build);
  [json, texts] = gs.model.scene_files (name, source, description);
  if (! isempty (options.controller))
    [json, source, texts] = controlled (json, texts{1}, options.controller, build);
  endif
  ## Octave keeps what it has loaded, so other contents have another name
  place = hash ("md5", [source "|" input])(1:8);
  contents = [texts{:}];
  if (! isempty (input))
    contents = [contents, fileread(input)];
  endif
  contents = hash ("md5", contents)(1:8);
  symbol = sprintf ("gsmbp_%s_%s_%s_%s", options.precision(1), tolower (json.name), place, ...
                    contents);
  before = stat (fullfile (build, options.precision, json.name, [symbol ".oct"]));
  file = gs.model.compile_module (json, source, build, options.precision, symbol, input);
  gs.files.load_module (symbol, file, before);

  m = gs.model.read_description (json);
  m.precision = options.precision;
  m.directory = folder;
  m.file = file;
  m.symbol = symbol;
  m.sources = {source, input};
  m.module = str2func (symbol);
  m.json = json;
  m.unique = gs.model.unique_routines (m);
  [names, m.units.parameters] = gs.given.names_and_units (json.parameters);
  m.par = cell2struct (num2cell (m.module ("par")), names, 1);
  m = gs.model.model_handles (m);
  m.initial = gs.model.initial_state (m);
  m = gsmbp_set (m, options.parameters);
  warn_of_start (m);
endfunction

## the scene with controllers, in a folder of what they are
function [json, source, texts] = controlled (json, text, list, build)
  said = hash ("md5", jsonencode (struct ("c", {list}, "text", text)))(1:12);
  place = fullfile (build, "controlled", said);
  [json, source, text] = gs.model.with_controller (json, text, list, place);
  texts = {text};
endfunction

## the start of the scene may be where a device cannot be; in loops it is a guess, closed later
function warn_of_start (m)
  inputs = zeros (1, m.sizes.nv);
  [~, off] = gs.start.constraint_residuals (m, 0, m.initial);
  if (any (abs (off) > 1e-6))
    return;
  endif
  for one = gs.start.range_margins (m, 0, m.initial', inputs)
    warning ("gsmbp_build: %s starts outside a margin: %s; another start, or m.initial", m.name,
             one.said);
  endfor
endfunction

## where Maxima writes if it runs in the working directory; where `make` has written
function folder = default_directory (name)
  folder = make_absolute_filename ("fortran_out");
  made = gs.files.own_place ("fortran_out");
  there = @(place) exist (fullfile (place, [name ".f"]), "file") == 2;
  if (! there (folder) && there (made))
    folder = made;
  endif
endfunction

## beside what was emitted, if one may write there
function build = default_build (folder)
  build = fullfile (folder, "build");
  place = {folder, build}{1 + isfolder(build)};
  if (isfolder (place) && system (["test -w '" strrep(place, "'", "'\\''") "'"]) != 0)
    build = fullfile ("fortran_out", "build");
  endif
endfunction

%!function m = fixture (name, varargin)
%!  addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%!  m = gsmbp_hand (name, varargin{:});
%!endfunction
%!test
%! m = fixture ("motor_pendulum");
%! assert (m.coordinates, {"q"});
%! assert (m.par.g, 9.81);
%! assert ({m.gsmbp_version, m.scene_hash}, {"", ""});   # the JSON was written by hand
%! assert (m.rhs (0, [0; 1; 0], 0), [1; -0.05/0.32; -2/0.0048], 1e-12);
%!test
%! m = fixture ("motor_pendulum", "parameters", struct ("b", 0));
%! assert (m.rhs (0, [0; 1; 0])(2), 0);
%!test
%! m = fixture ("hand_crank");
%! assert (m.skeleton.body, {"ground"; "crank"; "rod"; "slider"});
%! assert (m.ske (0, [pi/2; 0; 0.3]), ...
%!         [0 0 0 0 0 0.5 0.25 0.3; 0 0 0.2 0.1 0.2 0.2 0.2 0; 0 0 0 0 0 0 0 0], 1e-15);
%!error <argument q: expected 3 numbers> fixture ("hand_crank").ske (0, 1)
%!error <argument x: expected 3 numbers, found 2x1> fixture ("motor_pendulum").rhs (0, [0; 1])
%!error <argument x\(2\) is not finite: NaN> fixture ("motor_pendulum").rhs (0, [0; NaN; 0])
%!error <there is no .*nowhere.f> gsmbp_build ("nowhere")
%!error <unknown option "quad"> gsmbp_build ("nowhere", "quad", true)
%!test <a folder where a file should be; files that Maxima wrote in the working directory>
%! before = pwd ();
%! folder = tempname ();
%! mkdir (folder);
%! tidy = onCleanup (@() {cd(before), confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
%! cd (folder);
%! mkdir ("arm.json");
%! fail ("gsmbp_build (\"arm\")", "gsmbp_build: there is no .*arm.f; emit it first: .*arm.f`$");
%! mkdir ("fortran_out");
%! fclose (fopen (fullfile ("fortran_out", "arm.f"), "w"));
%! fail ("gsmbp_build (\"arm\")", "gsmbp_build: .*fortran_out.arm.f is empty");
%! fail ("gsmbp_build (\"arm\", \"directory\", \"x\")", ...
%!       "arm.f`; or give option directory: there is one in .*fortran_out$");
%! copyfile (fullfile ("fortran_out", "arm.f"), "arm.f");
%! fail ("gsmbp_build (\"arm\", \"directory\", \".\")", "is empty");
%! fputs (f = fopen ("arm.f", "w"), "      END\n");
%! fclose (f);
%! fail ("gsmbp_build (\"arm\", \"directory\", \".\")", ...
%!       "arm.json: expected a file, found a folder of this name");
%!error <unknown parameter "bb"> fixture ("motor_pendulum", "parameters", struct ("bb", 0))
%!test   # by its own name, or Octave loads it anew at every call once the path has grown
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%! profile on
%! m.rhs (0, m.initial, 0);
%! profile off
%! assert (any (strcmp ({profile("info").FunctionTable.FunctionName}, m.symbol)));
