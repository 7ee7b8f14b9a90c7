## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {@var{r} =} gsmbp_design (@var{m}, @var{specification})
## @deftypefnx {} {@var{r} =} gsmbp_design (@var{m}, @var{name}, @var{value}, @dots{})
## Design a machine: from what it is to do through springs, drives, gear ratios, controller and
## gains to a machine that was run, and a page that tells every decision with its reason.
##
## @var{m} is the model of an open chain, or of loops with one driven coordinate, in which a
## @code{dc_motor} drives each of these coordinates, best through a @code{lossy_gear}; their
## constants are parameters (what a scene leaves out) and are set by the choice (on a coordinate
## that slides @code{lossy_gear} has @code{ratio = 1*rad/m}).  An output of the scene measures
## each coordinate (@code{output(angle, q)}).  The @var{specification} is a struct, or names and
## values in turn:
## @table @code
## @item "motion"
## what the machine is to do: a plan of all driven coordinates (@code{gsmbp_plan}), or tasks, a cell
## array with rows @code{@{name, plan@}} or @code{@{name, plan, values@}}: a struct of parameters
## that are other ones in this task (a load).  The load cycle is that of all of them
## @item "accuracy"
## largest tracking error that is allowed, one number or one for each coordinate
## @item "supply", "current"
## largest voltage [V] and current [A] of the amplifiers, default Inf
## @item "motors", "gears", "screws", "goal", "inertia_ratio"
## catalogues (screws: of coordinates that slide), what the best is, largest load : motor inertia,
## as of @code{gsmbp_drive}
## @item "reserve"
## share of each limit that the drive is to leave free nominally, 0 to 0.9, default 0
## @item "period", "delay", "encoder", "step_out"
## [s]: sampling of the controller, its delay (0); steps of the measured coordinates and of the
## voltages (0: none)
## @item "Ms"
## largest sensitivity of the loops, default 1.6
## @item "Ms_corners"
## true: "Ms" is demanded at all corners of the tolerances (at most five), too, at all poses; by
## default of the nominal machine alone, and reported at the corners
## @item "support"
## rows @code{@{"s", @{length, ends@}@}}: unsupported length [m] and ends of the screw of a
## coordinate that slides, as of @code{gsmbp_drive}: then buckling and critical speed of the screw
## are limits
## @item "tolerances"
## rows @code{@{"m3", 0.1@}}: a parameter and the share by which it may be off, either way; all
## corners of up to three are run, of more those that derivatives call the worst.  These are carried
## with the runs where the scene was derived for them (request @code{sensitivity(m3)}), else
## differences
## @item "yield"
## a number of runs, default 0: the machine runs that often with parameters by chance within the
## tolerances
## @item "springs"
## rows @code{@{"k", [0 500]@}}: parameters that may be chosen so that the weight is balanced, and
## their bounds
## @item "axes"
## rows @code{@{"q1", names@}} where the scene has names of its own for what is set: a struct with
## some of R, L, K, J, B, n, eta, Tc, Jg (of the gear)
## @item "linear"
## a struct of parameters that the linear models take instead (dry friction of the scene, whose
## slope at rest pretends damping); that of the gears is left out anyway
## @item "tries"
## how many choices of drives are tried as whole machines, default 5
## @item "file"
## the page, @file{.html}; it fetches nothing
## @end table
##
## The way: springs by @code{gsmbp_optimize} (kept where the drives become better), load cycles by
## @code{gsmbp_inverse} and @code{gsmbp_cycle}, drives by @code{gsmbp_drive}, a PID controller for
## each axis by @code{gsmbp_pid} (the other axes locked; Ms is kept at five poses of each task, then
## with all loops closed), and feedforward of the voltages where the accuracy asks for it.  Then the
## non-linear machine runs through all tasks with its controller: samples, delay, steps of
## converters, saturation, friction and losses of the gears; nominally, and at the corners of the
## tolerances.  Continuous torque and heat are those of the tasks, repeated without a pause: what is
## to rest between them has to be in the plan.  Where a demand is not met the next
## drives of the order are tried.
##
## @var{r} has the fields
## @table @code
## @item met, unmet
## whether all demands are met; a struct array of those that are not: @code{axis}, @code{name},
## @code{found}, @code{demanded}, @code{where}, @code{said}.  They are a warning too
## @item decisions
## a struct array: @code{what}, @code{chosen}, @code{why} and @code{alternatives} (sentences)
## @item margins
## for each axis and quantity (tracking error, and the limits of the drive as in
## @code{gsmbp_drive}): @code{found}, @code{limit}, @code{used}; with tolerances @code{slope}
## (derivatives by the share of each), @code{first} (the largest to first order), @code{worst}
## (found at the @code{corner} of @code{corners})
## @item more
## what would have to change to get more, or to get it at all: @code{what}, @code{axis},
## @code{value}, @code{said}
## @item best, values, model
## pairs of @code{gsmbp_drive}, one for each axis; the parameters that were chosen; the model with
## them
## @item controller, machine, runs
## for @code{gsmbp_controller} and @code{gsmbp_loop}; the model with it; its runs, one for each
## task, with @code{planned} and @code{error}
## @item yield
## with option "yield": @code{runs}, @code{met}, @code{share}, @code{between} (a 95 % interval of
## the share), and @code{measures}, the same for each margin, with @code{worst}, the most that is
## used
## @item holding
## for each axis the largest load at rest, and the torque of a brake at the motor that holds it:
## @code{axis}, @code{load}, @code{torque}, @code{locks} (the gear locks itself), @code{where}
## @item derivatives
## how they were found
## @item axes, cycles, drives, attempts, laws, loops, poses, feedforward, references, corners
## the steps: load cycles, results of @code{gsmbp_drive}, choices that were tried with what they did
## not meet, controllers of @code{gsmbp_pid}, margins at the poses, what the controller's computer
## knows, runs at the corners
## @item notes
## what was not looked at
## @end table
##
## @c session octave
## @example
## >> pkg load control
## >> m = gsmbp_build ("slider_crank");
## >> plan = gsmbp_plan ("quintic", [0 1], [0 0.5]);
## >> own = struct ("n", "n", "R", "ra", "L", "la", "K", "km", "J", "jm", "B", "bm");
## >> o = @{"motion", plan, "accuracy", 0.01, "period", 2e-3, "inertia_ratio", 10@};
## >> r = gsmbp_design (m, o@{:@}, "axes", @{"q1", own@});
## >> r.met, r.best@{1@}.name
## ans = 1
## ans = S01+A049
## >> r.decisions(2).chosen
## ans = n = 49
## >> r.more(1).value
## ans = 2.1328
## @end example
##
## Errors: a specification without motion, accuracy or period; names that the scene does not have; a
## coordinate without a motor or an output; a parameter that stands for two axes.
## Source: own; of the steps as their functions say.
## @seealso{gsmbp_drive, gsmbp_pid, gsmbp_optimize, gsmbp_simulate, gsmbp_report}
## @end deftypefn

function r = gsmbp_design (m, varargin)
  if (nargin < 2)
    print_usage ();
  endif
  who = "gsmbp_design";
  if (isempty (which ("ss")))
    pkg load control
  endif
  gs.given.check_model (who, m);
  s = gs.machine.sort_limits (gs.machine.read_request (who, varargin));
  d = struct ("asked", s, "axes", gs.machine.read_axes (who, m, s));
  d.tasks = gs.drive.task_motions (who, m, d.axes, s.motion);
  d = gs.machine.check_design (who, m, d);
  d = gs.machine.add_springs (m, d);
  d = gs.machine.attempt_designs (who, d);
  d = gs.proof.yield_share (d);
  if (d.found)
    d.holding = gs.drive.holding_torques (d);
  endif
  d.decisions = gs.machine.list_decisions (d);
  d.notes = gs.machine.list_notes (d);
  d = gs.machine.more_options (d);
  if (! isempty (s.file))
    gs.machine.write_page (who, d, s.file);
  endif
  if (! isempty (d.unmet))
    warning ("gsmbp:design", "%s: %s: not met: %s", who, m.name, strjoin ({d.unmet.said}, "; "));
  endif
  r = gs.machine.design_result (d);
endfunction

%!shared m
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%!error <the specification lacks motion> gsmbp_design (m, struct ())
%!error <unknown option "motin", did you mean "motion"> gsmbp_design (m, struct ("motin", 1))
%!error <the specification lacks accuracy>
%! gsmbp_design (m, struct ("motion", gsmbp_plan ("quintic", [0 1], [0 1])));
