## -*- texinfo -*-
## @c category Linear models and control
## @deftypefn  {} {@var{c} =} gsmbp_schedule (@var{laws}, @var{signal}, @var{values})
## @deftypefnx {} {@var{c} =} gsmbp_schedule (@dots{}, "start", @var{k})
## A gain schedule: controllers for several trims as one, blended by what is measured.
##
## @var{laws} is a cell array of two or more controllers of @code{gsmbp_control} or
## @code{gsmbp_pid} with the same method, names, period, delay and sizes, designed about trims where
## the measurement @var{signal} has the @var{values} (strictly increasing).  Between two values
## outputs and next memory of both are blended linearly, trims included; outside the outer ones
## hold.
## Limits and converters are those of the first.
##
## The trim moves with @var{signal}: it is the reference that brings it back.  Laws without a
## reference of it (option "track" of @code{gsmbp_control}; a PID controller has one) hold the
## machine wherever it is put, those with integrals alone come back slowly or not at all: a warning
## says so.
##
## @var{c} is for @code{gsmbp_build} and @code{gsmbp_controller} as any controller.  It starts at
## the trim of number @var{k} of the laws (default 1): references and held outputs are there.
## @code{gsmbp_loop} tells margins of each of the @var{laws} at its own
## trim.
##
## @c session control
## @example
## >> soft = gsmbp_pid (tf (1, [1 1]), [], "pi", "pm", 60, "Ti", 1, "delay", 0.05, "period", 0.05);
## >> hard = gsmbp_pid (tf (4, [1 1]), [], "pi", "pm", 60, "Ti", 1, "delay", 0.05, "period", 0.05);
## >> c = gsmbp_schedule (@{soft, hard@}, "y1", [0 10]);
## >> c.schedule.values
## ans =
##
##     0   10
## @end example
##
## Errors: controllers that do not fit together; an unknown signal; values that do not increase; a
## start that is none of the laws.
## Source: own: blended laws.
## @seealso{gsmbp_control, gsmbp_pid, gsmbp_build, gsmbp_controller, gsmbp_lqr}
## @end deftypefn

function c = gsmbp_schedule (laws, signal, values, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_schedule";
  gs.given.refuse_words (who, "values", values);
  o = gs.given.call_options (who, {"start", 1, "number"}, varargin);
  if (! (iscell (laws) && numel (laws) > 1))
    error ("%s: argument laws: expected a cell array of two or more controllers, found %s", who, ...
           gs.text.shown_value (laws));
  endif
  c = laws{1};
  for k = 1:numel (laws)
    gs.controller.check_controller (who, laws{k});
    for field = {"method", "measured", "driven", "references", "period", "delay"}
      if (! isequal (laws{k}.(field{1}), c.(field{1})))
        error ("%s: controller %d has another %s than the first: expected %s, found %s", who, k, ...
               field{1}, gs.text.shown_value (c.(field{1})), ...
                   gs.text.shown_value (laws{k}.(field{1})));
      endif
    endfor
    if (rows (laws{k}.A) != rows (c.A))
      error (["%s: controller %d has another memory than the first: expected %d numbers, " ...
              "found %d"], who, k, rows (c.A), rows (laws{k}.A));
    endif
  endfor
  gs.given.check_kind (who, "argument signal", signal, "text");
  j = find (strcmp (signal, c.measured));
  if (isempty (j))
    error ("%s: argument signal: expected one of what is measured, found %s", who, ...
           gs.text.nearest_word (signal, c.measured));
  endif
  gs.given.check_kind (who, "argument values", values, "numbers");
  if (numel (values) != numel (laws) || ! all (diff (values(:)) > 0))
    error ("%s: argument values: expected %d strictly increasing numbers, found %s", who, ...
           numel (laws), gs.text.shown_value (values));
  endif
  if (! any (o.start == 1:numel (laws)))
    error ("%s: option start: expected the number of one of the %d laws, found %g", who, ...
           numel (laws), o.start);
  endif
  warn_of_no_reference (who, laws, signal);
  for field = {"y0", "r0", "u0"}
    c.(field{1}) = laws{o.start}.(field{1});
  endfor
  c.schedule = struct ("signal", j, "values", double (values(:)'), "laws", {laws(:)'});
endfunction

## whether no law answers the reference of the signal at once
function warn_of_no_reference (who, laws, signal)
  k = find (strcmp (laws{1}.references, [signal "_ref"]));
  at_once = @(law) any (law.D(:,numel (law.measured) + k)(:) != 0);
  if (isempty (k) || ! any (cellfun (at_once, laws)))
    warning ("gsmbp:schedule", ...
             ["%s: no law answers a reference of %s at once (option track of gsmbp_control): " ...
              "the trim moves with %s, and nothing but an integral brings it back"], who, ...
             signal, signal);
  endif
endfunction

%!testif ; ! isempty (pkg ("list", "control"))
%! pkg load control
%! law = @(k) gsmbp_pid (tf (k, [1 1]), [], "pi", "pm", 60, "Ti", 1, "delay", 0.05, "period", 0.05);
%! c = gsmbp_schedule ({law(1), law(4)}, "y1", [0 10]);
%! assert (c.schedule.signal, 1);
%! fail ("gsmbp_schedule ({law(1), law(4)}, \"y2\", [0 10])", "expected one of what is measured");
%! fail ("gsmbp_schedule ({law(1), law(4)}, \"y1\", [10 0])", "strictly increasing");
%! fail ("gsmbp_schedule ({law(1), law(4)}, \"y1\", [0 1], \"start\", 3)", "2 laws, found 3");
%! free_ = @(q) gsmbp_control (ss ([0 1; q 0], [0; 1], eye (2), 0), [], "lqr", "period", 0.1);
%! warning ("error", "gsmbp:schedule", "local");
%! fail ("gsmbp_schedule ({free_(1), free_(2)}, \"y1\", [0 1])", "no law answers a reference");
%!error <expected a cell array of two> gsmbp_schedule (1, "y", 1)
