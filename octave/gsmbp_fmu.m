## -*- texinfo -*-
## @c category Models
## @deftypefn  {} {@var{files} =} gsmbp_fmu (@var{scene})
## @deftypefnx {} {@var{files} =} gsmbp_fmu (@var{scene}, @var{folder})
## @deftypefnx {} {@var{files} =} gsmbp_fmu (@dots{}, @qcode{"method"}, @var{method})
## Write the scene file @var{scene} (.mac) as FMUs, for Simulink, OpenModelica, FMPy and others:
## @file{@var{folder}/@var{name}_fmi2.fmu} and @file{_fmi3.fmu}, of the standards 2.0 and 3.0,
## each for model exchange and co-simulation, with C sources, a binary for Linux and, where Debian's
## gcc-mingw-w64 is installed, one for Windows.  @var{folder} is @file{fmu_out} if it is not given.
##
## @var{method} is what integrates in co-simulation: @qcode{"dp853"} (default) or, for stiff scenes,
## @qcode{"radau"}.
##
## @var{files} is a cell with the two paths.  The chapter "Models that travel" of the manual says
## what stands in them, and which parts of a scene no FMU can hold.  Maxima's warnings about the
## scene are warnings here (@code{warning ("off", "gsmbp:derive")} silences them).
##
## @c session octave
## @example
## >> files = gsmbp_fmu ("examples/spinning_top/spinning_top.mac", "fmu_out")
## files =
## @{
##   [1,1] = fmu_out/spinning_top_fmi2.fmu
##   [1,2] = fmu_out/spinning_top_fmi3.fmu
## @}
## @end example
##
## Errors: a scene file that is not there; Maxima's error in one line; a program that is missing.
## Source: the standards FMI 2.0.4 and 3.0.2 of the Modelica Association.
## @seealso{gsmbp_derive, gsmbp_build}
## @end deftypefn

function files = gsmbp_fmu (scene, folder = "fmu_out", varargin)
  if (nargin < 1 || ! ischar (scene))
    print_usage ();
  endif
  gs.given.check_kind ("gsmbp_fmu", "argument folder", folder, "text");
  o = gs.given.call_options ("gsmbp_fmu", {"method", "dp853", {"dp853", "radau"}}, varargin);
  derive = gs.files.own_place ("share", "fmu", "derive");
  gs.model.run_maxima ("gsmbp_fmu", derive, scene, folder, o.method);
  [~, name] = fileparts (scene);
  files = {fullfile(folder, [name "_fmi2.fmu"]), fullfile(folder, [name "_fmi3.fmu"])};
endfunction

%!error <there is no scene file nowhere.mac> gsmbp_fmu ("nowhere.mac")
%!error <gsmbp_fmu: option method: expected one of "dp853", "radau", found "gauss">
%! gsmbp_fmu ("nowhere.mac", "fmu_out", "method", "gauss");
