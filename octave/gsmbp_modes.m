## -*- texinfo -*-
## @c category Linear models and control
## @deftypefn  {} {@var{r} =} gsmbp_modes (@var{m}, @var{x})
## @deftypefnx {} {@var{r} =} gsmbp_modes (@dots{}, "hold", @var{names}, "steady", true)
## @deftypefnx {} {@var{r} =} gsmbp_modes (@dots{}, "spin", @var{name}, "speeds", @var{values})
## Frequencies, damping ratios and shapes of small vibrations about a state, at rest or spinning.
##
## The model @var{m} is linearized by its exact Jacobians at the state @var{x} (@var{nx} states, or
## the @var{nq} coordinates alone: the rest is then at its start, speeds zero).  With loops or Euler
## parameters the modes are those of the independent deviations.  They are the modes of a motion
## where @var{x} is an equilibrium or a steady motion (a blade that spins); elsewhere they are those
## of the coefficients at @var{x}, and a warning gives the largest acceleration.
##
## Options:
## @table @code
## @item "hold"
## names of coordinates that keep their motion: their speeds are held as they are by efforts of any
## size, they do not vibrate (a shaft that is driven at constant speed)
## @item "steady"
## true: coordinates and states of devices that are not held are first moved, from @var{x}, to where
## nothing but what is held moves at other than constant speed (the sag under gravity, the
## deflection of a blade as it spins); speeds stay as given (false by default)
## @item "spin", "speeds"
## Campbell diagram: a coordinate, which is held, and the speeds that it takes, one after the other
## (the frequencies are then columns); with "file" it is drawn too
## @item "file"
## PNG, PDF, SVG or EPS of the Campbell diagram, a .csv with the same numbers beside it
## @item "orders"
## lines of these multiples of the speed in the diagram ([1 2 3] by default)
## @item "time", "input"
## @var{t} [s] (0) and the @var{nv} inputs (zeros)
## @item "start"
## "check" or "project", as in @code{gsmbp_simulate}
## @end table
##
## @var{r} has the fields
## @table @code
## @item frequency
## of each mode that oscillates, the absolute value of its pair of eigenvalues [rad/s], ascending
## @item damping
## its damping ratio, negative where it grows
## @item shapes
## a column for each mode, a row for each coordinate (in a scene without coordinates, for each
## state): complex amplitudes, the largest of them 1, zeros where states of devices vibrate alone
## @item eigenvalues
## of each mode, that with positive imaginary part [1/s]
## @item real
## the eigenvalues without imaginary part [1/s], ascending; positive: it grows (divergence)
## @item rigid
## how many eigenvalues are zero: what can be moved without any effect, and constant speeds.  Such a
## rigid mode has no column in @code{shapes}; its shape is the displacement without any effect, and
## its coordinates move along in the other modes, so that the momentum stays (of two free discs with
## a torsion spring between them, in angles relative to ground, the first by -J2/J1 where the second
## moves by 1)
## @item x
## the state about which they are
## @end table
## With "spin" @code{frequency}, @code{damping}, @code{eigenvalues} and @code{x} have a column for
## each entry of @code{speeds}, @code{shapes} a page, @code{real} is a cell array, @code{rigid} a
## row; a row of @code{frequency} follows one mode by its shape from speed to speed, NaN where it is
## none (it does not oscillate).
##
## Without an output argument frequencies, damping and the largest amplitudes are printed.
## Eigenvalues below 1e-9 of the largest one are taken as zero.
##
## @c session octave
## @example
## >> gsmbp_derive ("examples/rotating_blade/rotating_blade.mac", "fortran_out");
## >> m = gsmbp_build ("rotating_blade");
## >> gsmbp_modes (m, m.initial, "spin", "theta", "speeds", [0 3 6])
## rotating_blade: frequencies [rad/s] by speed [rad/s]
##           0 :     3.79773     3.79773        23.8        23.8     66.6406     66.6406
##           3 :     4.09756     5.07838     24.8938     25.0739     67.8524     67.9187
##           6 :     4.81399      7.6925     27.9294     28.5666     71.3655     71.6173
## >> x = m.initial;
## >> x(strcmp (m.states, "theta_d")) = 6;
## >> r = gsmbp_modes (m, x, "hold", "theta");
## >> r.frequency(1:2)'
## ans =
##
##    4.8140   7.6925
## @end example
##
## Errors: a model without the subroutine JAC, with "hold" LIN; a derivative that is not finite; a
## state that does not fulfil the constraints; an unknown coordinate; no steady state is found.
## Source: own: eigenvalues of the exact Jacobians on the constraints' tangent space.
## @seealso{gsmbp_linear, gsmbp_trim}
## @end deftypefn

function r = gsmbp_modes (m, x, varargin)
  if (nargin < 2)
    print_usage ();
  endif
  who = "gsmbp_modes";
  gs.given.check_model (who, m);
  gs.given.refuse_words (who, "x", x);
  if (! any (strcmp (m.subroutines, "jac")))
    gs.given.need_jacobian (who, m);
  endif
  table = {"hold", {}, "names"; "steady", false, "flag"
           "spin", "", "text"; "speeds", [], "numbers"
           "file", "", "text"; "orders", [1, 2, 3], "numbers"
           "time", 0, "number"; "input", [], "numbers"
           "start", "check", {"check", "project"}};
  o = gs.given.call_options (who, table, varargin);
  [held, spin] = what_is_held (who, m, o);
  p = struct ("m", m, "t", o.time, "steady", o.steady, "start", o.start, "held", held);
  p.v = gs.given.given_vector (who, "option input", merge (isempty (o.input), ...
                                                           zeros (m.sizes.nv, 1), ...
                               o.input), m.sizes.nv, sprintf (" (the inputs %s)", ...
                               strjoin (m.inputs', ", ")), m.inputs);
  rest = m.initial(m.sizes.nq+1:end);
  rest(1:m.sizes.nu) = 0;
  x = gs.given.given_guess (who, m, "x", x, rest);
  if (isempty (spin))
    [one, doubt] = modes_at (p, x);
  else
    [one, doubt] = over_speeds (p, x, spin, held(end,2), o.speeds(:)');
    draw (m, one, o);
  endif
  if (! isempty (doubt))
    warning ("gsmbp:equilibrium", ["%s: %s: expected an equilibrium or a steady motion; found " ...
             "%s; gsmbp_trim finds one, or option \"steady\""], who, m.name, doubt);
  endif
  gs.start.warn_of_rank (who, m, o.time, one.x(:,1), "singular_linear");
  if (nargout > 0)
    r = one;
  else
    show (m, one);
  endif
endfunction

## rows of coordinate and speed; the one that spins is the last
function [held, spin] = what_is_held (who, m, o)
  spin = o.spin;
  if (isempty (spin) != isempty (o.speeds))
    error ("%s: options \"spin\" and \"speeds\" come together: expected both, found one", who);
  endif
  if (isempty (spin) && ! isempty (o.file))
    error ("%s: option \"file\" is of a Campbell diagram: expected \"spin\" and \"speeds\"", who);
  endif
  names = gs.given.asked_names (o.hold)';
  if (! isempty (spin))
    names = [names(! strcmp (names, spin)), {spin}];
  endif
  held = zeros (numel (names), 2);
  for k = 1:numel (names)
    option = {"hold", "spin"}{1 + strcmp(names{k}, spin)};
    held(k,:) = gs.given.speed_and_value (who, m, option, names{k});
  endfor
  if (! isempty (held) && ! all (ismember ({"lin", "mas"}, m.subroutines)))
    error (["%s: %s was emitted without the subroutines LIN and MAS, which \"hold\" needs: add " ...
            "the requests linear, mass"], who, m.name);
  endif
endfunction

## modes of the one state X; DOUBT: its largest acceleration, "" where there is none
function [r, doubt] = modes_at (p, x)
  [m, who] = deal (p.m, "gsmbp_modes");
  x = gs.start.consistent_start (who, m, p.t, x, p.start);
  at = gs.linear.state_place (m, p.t, x, p.v);
  [verdict, text, x, doubt, e, frequency, damping, shapes, real_, rigid] = ...
      m.module ("modes", at{:}, p.held', p.steady);
  gs.linear.heed_verdict (who, m, verdict, text);
  r = struct ("eigenvalues", e, "frequency", frequency, "damping", damping, "shapes", shapes, ...
              "real", real_, "rigid", rigid, "x", x);
endfunction

## the modes at each of the speeds U of the coordinate SPIN, each followed by its shape
function [r, doubt] = over_speeds (p, x, spin, u, speeds)
  n = numel (speeds);
  doubt = "";
  for k = 1:n
    x(p.m.sizes.nq + u) = speeds(k);
    if (p.m.sizes.nlam > 0 && strcmp (p.start, "project"))
      x = gsmbp_assemble (p.m, x, "hold", spin, "time", p.t);
    endif
    [found(k), more] = modes_at (p, x);
    doubt = {doubt, more}{1 + isempty(doubt)};   # the first one
    x = found(k).x;
  endfor
  [row, nrows] = p.m.module ("followed modes", cellfun (@numel, {found.frequency}), ...
                             [found.shapes], vertcat (found.frequency));
  first = NaN (nrows, n);
  r = struct ("speeds", speeds, "frequency", first, "damping", first, "eigenvalues", first, ...
              "shapes", NaN (rows (found(1).shapes), nrows, n), "real", {{found.real}}, ...
              "rigid", [found.rigid], "x", [found.x]);
  for k = 1:n
    own = row(1:numel (found(k).frequency));
    row(1:numel (own)) = [];
    for name = {"frequency", "damping", "eigenvalues"}
      r.(name{1})(own,k) = found(k).(name{1});
    endfor
    r.shapes(:,own,k) = found(k).shapes;
  endfor
endfunction

## the Campbell diagram
function draw (m, r, o)
  if (isempty (o.file))
    return;
  endif
  order = abs (r.speeds') * o.orders(:)';
  names = arrayfun (@(k) sprintf ("mode %d: %s", k, main_part (m, r.shapes(:,k,:))), ...
                    1:rows (r.frequency), "UniformOutput", false);
  lines_ = arrayfun (@(k) sprintf ("%g x speed", k), o.orders(:)', "UniformOutput", false);
  frequency = struct ("y", [r.frequency', order], "names", {[names, lines_]}, ...
                      "label", "frequency [rad/s]");
  damping = struct ("y", r.damping', "names", {names}, "label", "damping ratio [1]");
  panels = {frequency, damping}(1:1 + any (abs (r.damping(:)) > 1e-6));
  gsmbp_plot (o.file, r.speeds', panels{:}, "title", ["Campbell diagram of " m.name], ...
              "xlabel", ["speed of " o.spin " [rad/s]"], "head", "speed", ...
              "size", [16, 9 * numel(panels) + 3]);
endfunction

## the coordinate that moves most in a mode where it is first seen
function name = main_part (m, shapes)
  k = find (! isnan (shapes(1,1,:)), 1);
  [~, top] = max (abs (shapes(:,1,k)));
  name = m.coordinates{top};
endfunction

function show (m, r)
  if (isfield (r, "speeds"))
    printf ("%s: frequencies [rad/s] by speed [rad/s]\n", m.name);
    printf (["%11.5g :" repmat(" %11.6g", 1, rows (r.frequency)) "\n"], [r.speeds; r.frequency]);
    return;
  endif
  printf ("%s: %d modes\n%16s %12s  amplitudes\n", m.name, numel (r.frequency), ...
          "frequency [rad/s]", "damping");
  for k = 1:numel (r.frequency)
    [~, order] = sort (abs (r.shapes(:,k)), "descend");
    order = order(1:min (3, end))(:)';
    said = arrayfun (@(i) sprintf ("%s %.3g", m.states{i}, abs (r.shapes(i,k))), order, ...
                     "UniformOutput", false);
    printf ("%17.6g %12.3g  %s\n", r.frequency(k), r.damping(k), strjoin (said, ", "));
  endfor
  printf ("real eigenvalues [1/s]: %s; zero: %d\n", mat2str (r.real', 5), r.rigid);
endfunction

%!error <Invalid call> gsmbp_modes (1)
