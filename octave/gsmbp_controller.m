## -*- texinfo -*-
## @c category Linear models and control
## @deftypefn  {} {@var{files} =} gsmbp_controller (@var{c}, @var{folder})
## @deftypefnx {} {@var{files} =} gsmbp_controller (@var{c}, @var{folder}, @var{scene})
## A controller as Fortran 77 and C99 of its own, for the computer of the machine.
##
## @var{c} is a controller with a period (@code{gsmbp_control}, @code{gsmbp_pid}).  Into the
## @var{folder} (made if it is not there) come NAME.f with @code{SUBROUTINE NAME( Y, R, Z, U )} and
## NAME.c with @code{void NAME (const double *y, const double *r, double *z, double *u)}, NAME.h
## with its sizes, period and delay; @code{NAME_START( Z, U, PER, DEL )} and @code{NAME_start (z,
## u)}.  One call is one sample: of the measurements Y and the references R it makes the outputs U
## and the next memory Z, which is zero at the trim.
## Limits and converters are in it.  It needs nothing else.  NAME is @code{c.name}.
##
## A controller of @code{gsmbp_model_control} calculates with the scene: @var{scene} is the file of
## it, which is derived with the subroutines that the controller calls.  NAME.f has them and what
## they call; beside NAME.c, NAME.h come the scene's C, the run time in C and its headers: compile
## every @file{.c} of the folder, with the folder among the include paths (@code{-I}).  The call
## has the time, NAME( T, Y, R, Z, U ), and U must hold the outputs of the sample before: they stay
## where the loops do not close or the drives cannot give the motion, and Z counts it.
##
## @c session control
## @example
## >> pkg load control
## >> A = [0 1; 0 0]; B = [0; 1];
## >> c = gsmbp_control (ss (A, B, [1 0], 0), [], "lqg", "period", 0.01, "name", "hold");
## >> files = gsmbp_controller (c, "target");
## >> [~, names, kinds] = cellfun (@@fileparts, files, "UniformOutput", false);
## >> strcat (names, kinds)
## ans =
## @{
##   [1,1] = hold.f
##   [1,2] = hold.c
##   [1,3] = hold.h
## @}
##
## @end example
##
## Errors: a controller without a period; a name that is none of Fortran and C; a folder that cannot
## be written; a file of a scene that is missing, or not that of the controller.
## Source: own.
## @seealso{gsmbp_control, gsmbp_pid, gsmbp_build}
## @end deftypefn

function files = gsmbp_controller (c, folder, scene)
  if (nargin < 2 || ! ischar (folder))
    print_usage ();
  endif
  who = "gsmbp_controller";
  if (nargin < 3)
    scene = "";
  endif
  if (isstruct (c) && isfield (c, "scene"))
    gs.controller.check_name (who, c);
    files = gs.controller.target_files (who, c, folder, scene);
    return;
  endif
  gs.controller.check_controller (who, c);
  if (! isempty (scene))
    error ("%s: the controller %s (%s) is linear: expected no scene, found %s", who, c.name, ...
           c.method, gs.text.shown_value (scene));
  endif
  gs.files.make_folder (who, folder);
  file = @(kind) fullfile (folder, [c.name kind]);
  files = {file(".f"), file(".c"), file(".h")};
  gs.files.write_text (who, files{1}, [gs.controller.text_in_fortran(c, upper (c.name)), ...
                                 gs.controller.start_text(c, upper (c.name))]);
  [text, header] = gs.controller.text_in_c (c, c.name);
  gs.files.write_text (who, files{2}, text);
  gs.files.write_text (who, files{3}, header);
endfunction

%!testif ; ! isempty (pkg ("list", "control"))
%! pkg load control
%! c = gsmbp_control (ss ([0 1; 0 0], [0; 1], [1 0], 0), [], "lqg", "period", 0.01);
%! folder = tempname ();
%! guard = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
%! files = gsmbp_controller (c, folder);
%! assert (all (cellfun (@(f) exist (f, "file"), files) == 2));
%! c.name = "1";
%! fail ("gsmbp_controller (c, folder)", "expected a name of letters");
%!error <expected a controller of gsmbp_control> gsmbp_controller (1, "x")
