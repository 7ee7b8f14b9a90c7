## -*- texinfo -*-
## @c category Models
## @deftypefn  {} {[@var{cpu}, @var{wall}] =} gsmbp_derive (@var{scene})
## @deftypefnx {} {[@var{cpu}, @var{wall}] =} gsmbp_derive (@var{scene}, @var{folder})
## Derive the scene file @var{scene} (.mac; it gives the variable @code{scene} its
## value) by Maxima and write its Fortran and
## .json into @var{folder}; without one they are only derived, to measure it.
##
## Maxima's warnings about the scene are warnings here
## (@code{warning ("off", "gsmbp:derive")} silences them).
##
## @var{cpu} and @var{wall} are seconds of processor and clock; Maxima's start
## and the loading of GSMBP are in them.
##
## @c session octave
## @example
## >> cpu = gsmbp_derive ("examples/spinning_top/spinning_top.mac", "fortran_out");
## >> m = gsmbp_build ("spinning_top");
## >> m.coordinates'
## ans =
## @{
##   [1,1] = e0
##   [1,2] = e1
##   [1,3] = e2
##   [1,4] = e3
## @}
## @end example
##
## Errors: a scene file that is not there; Maxima's error in one line.
## Source: own.
## @seealso{gsmbp_build}
## @end deftypefn

function [cpu, wall] = gsmbp_derive (scene, folder)
  if (nargin < 1 || ! ischar (scene))
    print_usage ();
  endif
  given = nargin > 1;
  if (given)
    gs.given.check_kind ("gsmbp_derive", "argument folder", folder, "text");
  else
    folder = tempname ();
    guard = onCleanup (@() remove (folder));
  endif
  start = tic ();
  try
    text = gs.model.run_maxima ("gsmbp_derive", gs.files.own_place ("share", "make", "derive"), ...
                                scene, folder);
  catch problem
    if (! given)
      problem.message = regexprep (problem.message, " \\(log: [^()]*\\)$", "");
    endif
    error ("%s", problem.message);
  end_try_catch
  wall = toc (start);
  ## the last line of the shell's `times`: user and system seconds of what it started
  spent = regexp (text, '(\d+)m([\d.]+)s\s+(\d+)m([\d.]+)s\s*$', "tokens"){1};
  spent = str2double (spent);
  cpu = [60 1 60 1] * spent(:);
endfunction

function remove (folder)
  if (exist (folder, "dir"))
    confirm_recursive_rmdir (false, "local");
    rmdir (folder, "s");
  endif
endfunction

%!error <there is no scene file nowhere.mac> gsmbp_derive ("nowhere.mac")
