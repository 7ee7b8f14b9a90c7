## -*- texinfo -*-
## @c category Linear models and control
## @deftypefn  {} {@var{r} =} gsmbp_loop (@var{c})
## @deftypefnx {} {@var{r} =} gsmbp_loop (@var{c}, @var{file})
## @deftypefnx {} {@var{r} =} gsmbp_loop (@var{c}, @var{file}, @var{mc}, @var{run})
## Margins of a control loop, and a page that shows it.
##
## @var{c} is a controller of @code{gsmbp_control} or @code{gsmbp_pid}.  Its loop is broken at each
## input of the plant, the others stay closed; samples and delays are exact.  @var{r} is a struct
## array, one entry an input, with the fields @code{input}, @code{phase} [rad] at @code{crossover}
## [rad/s], @code{gain} (the least factor that makes it unstable, above 1) at
## @code{phase_crossover}, @code{gain_down} (the largest below 1; 0: none), @code{Ms}, the largest
## |1/(1 + L)|, at @code{Ms_at}, @code{delay} [s], that the loop bears.
##
## The @var{file} is a PNG, PDF, SVG or EPS with the Bode diagram, the Nyquist diagram, the root
## locus (poles as all gains grow from 0 to ten times; the closed ones marked) and responses in
## time: those of the machine, @var{run} of @code{gsmbp_simulate} of the model @var{mc} with the
## controller, beside those of the linear model from the same start with the same references;
## without them the answer of the linear model to steps of the references, or of a force at the
## first input where there are none; what is small beside the rest has an axis of its own at the
## right.  A .csv beside it has the loop by frequencies.  Option "size":
## [cm], default [24 27].
##
## @c session control
## @example
## >> pkg load control
## >> A = [0 1; 0 0]; B = [0; 1];
## >> c = gsmbp_control (ss (A, B, eye (2), 0), [], "lqr", "Q", [1 0], "R", 1);
## >> r = gsmbp_loop (c);
## >> [r.phase * 180 / pi, r.gain, r.Ms]
## ans =
##
##    65.5302       Inf    1.0000
## @end example
##
## Errors: no controller; a run of another model; a file that cannot be written.
## Source: own; the drawing is gnuplot's.
## @seealso{gsmbp_control, gsmbp_pid, gsmbp_build, gsmbp_simulate}
## @end deftypefn

function r = gsmbp_loop (c, file, mc, run, varargin)
  if (nargin < 1 || (nargin > 1 && ! ischar (file)) || nargin == 3)
    print_usage ();
  endif
  who = "gsmbp_loop";
  if (! (isstruct (c) && isscalar (c) && all (isfield (c, {"plant", "A", "G", "driven", "x0"}))))
    error ("%s: argument c: expected a controller of gsmbp_control or gsmbp_pid, found %s", who, ...
           gs.text.shown_value (c));
  endif
  if (isfield (c, "schedule"))
    error (["%s: %s is a schedule: its loop is another at each point; expected one of its " ...
            "controllers, c.schedule.laws{k}"], who, c.name);
  endif
  o = gs.given.call_options (who, {"size", [24, 27], "numbers"}, varargin);
  w = frequencies (c);
  for i = 1:numel (c.driven)
    f = gs.control.loop_response (c, i);
    one = gs.control.loop_margins (f, w);
    one.input = c.driven{i};
    all_(i) = one;
    L(i,:) = f (w);
  endfor
  if (nargin > 1)
    if (nargin < 4)
      [mc, run] = deal ([]);
    endif
    gs.given.refuse_words (who, "mc", mc, "run", run);
    gs.control.loop_page (who, file, c, w, L, all_, mc, run, o.size);
  endif
  if (nargout > 0 || nargin == 1)
    r = all_;
  endif
endfunction

## where plant and controller show what they do
function w = frequencies (c)
  h = c.period;
  s = [eig(c.plant.a); eig(c.A)];
  if (h > 0)
    s = log (s(abs (s) > 1e-6)) / h;
  endif
  p.A = diag ([real(s); 0]) + 1i * diag ([imag(s); 0]);
  p.h = h;
  w = gs.control.frequency_grid (p, c.delay * (h == 0), []);
endfunction

%!testif ; ! isempty (pkg ("list", "control"))
%! pkg load control
%! c = gsmbp_control (ss ([0 1; 0 0], [0; 1], eye (2), 0), [], "lqr", "Q", [1 0], "R", 1);
%! r = gsmbp_loop (c);
%! assert (r.Ms, 1, 1e-6);   # of an LQR the loop stays outside the circle of radius 1 about -1
%! assert (r.crossover, sqrt (1 + sqrt (2)), 1e-12);
%! if (! isempty (file_in_path (getenv ("PATH"), "gnuplot")))
%!   file = [tempname() ".svg"];
%!   gsmbp_loop (c, file);
%!   assert (! isempty (strfind (fileread (file), "Nyquist")));
%!   delete (file);
%!   delete ([file(1:end-3) "csv"]);
%! endif
%!error <expected a controller> gsmbp_loop (1)
