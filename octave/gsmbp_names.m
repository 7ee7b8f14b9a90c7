## -*- texinfo -*-
## @c category Models
## @deftypefn  {} {} gsmbp_names (@var{m})
## @deftypefnx {} {@var{t} =} gsmbp_names (@var{m})
## The names of all that a model's results hold: states, inputs, outputs, places of points and
## frames (@code{"tip.x"}), efforts, multipliers, margins, each with its unit and what it is.
##
## Without a result the table is printed.  @var{t} is a struct array with the fields
## @code{name}, @code{unit}, @code{kind}, @code{meaning}, and @code{field} and @code{column},
## where the numbers stand in a result @var{r} of @code{gsmbp_simulate} or
## @code{gsmbp_inverse}: @code{r.of.("drive.i")} is the same as @code{r.x(:,3)} here.  Any name is
## possible, also @code{t}, @code{x} or @code{y}; a name that is there twice has its kind behind it.
## @code{gsmbp_plot} and @code{gsmbp_csv} take these names.
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> gsmbp_names (m);
## q1               rad    state       coordinate of revolute A
## q2               rad    state       coordinate of revolute B
## q3               m      state       coordinate of prismatic D
## ...
## @end example
##
## Errors: an argument that is no model.
## Source: own.
## @seealso{gsmbp_build, gsmbp_plot, gsmbp_csv}
## @end deftypefn

function t = gsmbp_names (m)
  if (nargin != 1)
    print_usage ();
  endif
  gs.given.check_model ("gsmbp_names", m);
  t = gs.model.name_table (m);
  if (nargout == 0)
    wide = @(list) max ([cellfun(@numel, list), 1]);
    form = sprintf ("%%-%ds  %%-%ds  %%-%ds  %%s\n", wide ({t.name}), wide ({t.unit}), ...
                    wide ({t.kind}));
    for row = t
      printf (form, row.name, row.unit, row.kind, row.meaning);
    endfor
    clear t;
  endif
endfunction

%!test
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%! t = gsmbp_names (m);
%! assert ({t.name}, {"q", "q_d", "drive.i", "drive.v", "offset", "effort.q"});
%! assert ({t.unit}, {"rad", "rad/s", "A", "V", "m", "N*m"});
%! r = gsmbp_simulate (m, [0.2 0 0], [0 0.1 0.2], "input", 3);
%! assert (r.of.("drive.i"), r.x(:,3));
%! assert (r.of.("offset"), 0.5 * sin (r.x(:,1)), 1e-14);
%!error <Invalid call> gsmbp_names ()
