## -*- texinfo -*-
## @c category Speed and accuracy
## @deftypefn  {} {@var{s} =} gsmbp_timing (@var{m}, @var{t}, @var{x})
## @deftypefnx {} {@var{s} =} gsmbp_timing (@dots{}, "input", @var{v}, "qj", @var{qj})
## @deftypefnx {} {@var{s} =} gsmbp_timing (@dots{}, "seconds", @var{seconds}, "print", @var{yes})
## Time for one call of each emitted subroutine of the model @var{m}, called
## again and again within compiled code at the time @var{t}, the states @var{x}
## and the inputs @var{v} (zeros by default).
##
## @var{qj} is the motion for CMD and CLO (of @code{gsmbp_inverse}); without it
## they are left out.  Every subroutine is repeated for about @var{seconds}
## (default 0.02), three times; the shortest counts.  PRJ and CLO work in
## place: from the second call on they find a state that is already consistent,
## which is the cost behind each step of an integration.
##
## @var{s} is a struct of seconds for each call: @code{s.rhs} and so on.
## "print" (default true) also writes the table with the operation counts of
## the .json.
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> s = gsmbp_timing (m, 0, m.initial, "seconds", 0.001, "print", false);
## >> fieldnames (s)'
## ans =
## @{
##   [1,1] = kin
##   [1,2] = inv
##   [1,3] = mas
##   [1,4] = bia
##   [1,5] = fwd
##   [1,6] = con
##   [1,7] = inl
##   [1,8] = lin
##   [1,9] = acc
##   [1,10] = rhs
##   [1,11] = prj
##   [1,12] = jac
##   [1,13] = out
##   [1,14] = ene
##   [1,15] = ske
## @}
## @end example
##
## Errors: arguments of other sizes, an unknown option.
## Source: own; the least of three repetitions.
## @seealso{gsmbp_build, gsmbp_workprecision}
## @end deftypefn

function s = gsmbp_timing (m, t, x, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_timing";
  gs.given.check_model (who, m);
  gs.given.refuse_words (who, "t", t, "x", x);
  d = m.sizes;
  table = {"input", zeros(d.nv, 1), "numbers"
           "qj", [], "numbers"
           "seconds", 0.02, "positive"
           "print", true, "flag"};
  o = gs.given.call_options (who, table, varargin);
  t = gs.given.given_vector (who, "t", t, 1);
  x = gs.given.given_vector (who, "x", x, d.nx, sprintf (" (the states of %s)", m.name), m.states);
  o.input = gs.given.given_vector (who, "option input", o.input, d.nv, "", m.inputs);
  q = x(1:d.nq);
  u = x(d.nq + (1:d.nu));
  zero = zeros (d.nu, 1);
  calls.kin = {t, q, u};
  calls.inv = {t, q, u, zero};
  calls.mas = {t, q};
  calls.bia = {t, q, u};
  calls.fwd = {t, q, u, zeros(d.nv, 1), zero};
  calls.con = {t, q, u};
  calls.inl = {t, q, u, zero};
  calls.lin = {t, q, u, zero};
  calls.acc = calls.rhs = calls.jac = calls.out = calls.ene = {t, x, o.input};
  calls.ske = {t, q};
  calls.prj = {t, x};
  calls.cmd = calls.clo = {t, o.qj};
  known = fieldnames (calls)';
  if (isempty (o.qj))
    known = setdiff (known, {"cmd", "clo"});
  endif
  s = struct ();
  for name = intersect (m.subroutines', known, "stable")
    s.(name{1}) = one_call (m, o.seconds, name{1}, calls.(name{1}));
  endfor
  if (o.print)
    show (m, s);
  endif
endfunction

function best = one_call (m, seconds, name, given)
  module = m.module;
  per_call = @(n) module ("time", n, name, m.cst, given{:});
  n = 100;
  while (n * per_call (n) < seconds / 4 && n < 1e8)
    n *= 4;
  endwhile
  best = min (arrayfun (@(k) per_call (n), 1:3));
endfunction

## the operations of the text of a subroutine, without those of what it calls
function c = own (subroutine)
  c = subroutine.operations;
  if (isfield (subroutine, "own_operations"))
    c = subroutine.own_operations;
  endif
endfunction

function show (m, s)
  names = cellfun (@(one) tolower (one(numel (m.name)+2:end)), {m.json.subroutines.name}, ...
                   "UniformOutput", false);
  printf ("%s: operations of the emitted subroutines, nanoseconds for one call\n", m.name);
  printf ("%-10s %6s %6s %5s %5s %5s %9s\n", "subroutine", "mul", "add", "div", "sqrt", "trig", ...
          "ns/call");
  for k = 1:numel (names)
    c = struct ("mul", -1, "add", -1, "div", -1, "sqrt", -1, "trig", -1);   # written by hand
    if (isfield (m.json.subroutines, "operations"))
      c = own (m.json.subroutines(k));
    endif
    time = "-";
    if (isfield (s, names{k}))
      time = sprintf ("%.0f", 1e9 * s.(names{k}));
    endif
    printf ("%-10s %6d %6d %5d %5d %5d %9s\n", toupper (names{k}), c.mul, c.add, c.div, c.sqrt, ...
            c.trig, time);
  endfor
endfunction

%!test
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%! s = gsmbp_timing (m, 0, [0.3 1 0], "seconds", 1e-4, "print", false);
%! assert (s.rhs > 1e-10 && s.rhs < 1e-4);
%! assert (m.rhs (0, [0; 1; 0], 0)(1), 1);
%!error <gsmbp_timing: argument x: expected 3 numbers>
%! gsmbp_timing (gsmbp_hand ("motor_pendulum"), 0, [0.3 1], "print", false)
