## -*- texinfo -*-
## @c category Models
## @deftypefn  {} {@var{m} =} gsmbp_set (@var{m}, @var{name}, @var{value}, @dots{})
## @deftypefnx {} {@var{m} =} gsmbp_set (@var{m}, @var{values})
## The model @var{m} of @code{gsmbp_build} with other parameter values (SI
## units), given by name and value or as the fields of the struct @var{values}.
##
## What depends on the parameters alone is computed anew and the handles of the
## result use it; the argument keeps its own.  A start that the scene states by
## parameters, and filters and observers that start settled, follow in @code{m.initial}; beams that
## start sagged stay where they were. What the
## scene would refuse is an error here: a negative mass or principal moment, a value out of
## the range of a device.
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> heavy = gsmbp_set (m, "m3", 2);
## >> m.mas (0, [0; 0; 0.7])(3,3), heavy.mas (0, [0; 0; 0.7])(3,3)
## ans = 1
## ans = 2
## @end example
##
## Errors: an unknown parameter, one that is made of others, a value that is
## no finite number or that the scene refuses.
## Source: own.
## @seealso{gsmbp_build}
## @end deftypefn

function m = gsmbp_set (m, varargin)
  if (nargin < 2)
    print_usage ();
  endif
  gs.given.check_model ("gsmbp_set", m);
  old = m;
  m.par = merged (m, varargin);
  others = any ([struct2cell(m.par){:}] != [struct2cell(old.par){:}]);
  if (others)
    gs.model.need_checks (m);
  endif
  gs.model.check_values (m);
  m = gs.model.model_handles (m);
  if (others)
    m.initial = moved (old, m);
  endif
endfunction

## the start that the scene states, where it was as stated
function x = moved (old, m)
  [before, after] = deal (gs.model.initial_state (old), gs.model.initial_state (m));
  x = old.initial;
  stated = abs (x - before) <= 1e-9 * (m.nominal + abs (before));
  x(stated) = after(stated);
endfunction

function par = merged (m, pairs)
  par = m.par;
  [names, values] = gs.given.name_value_pairs (["gsmbp_set: " m.name], "parameter", pairs);
  for i = 1:numel (names)
    [name, value] = deal (names{i}, values{i});
    gs.given.check_parameter ("gsmbp_set", m, name);
    if (! (isnumeric (value) && isscalar (value) && isreal (value) && isfinite (value)))
      error ("gsmbp_set: %s: %s", m.name, ...
             gs.text.refusal_text ("parameter", name, gs.text.shown_value (value)));
    endif
    par.(name) = double (value);
  endfor
endfunction

%!shared m
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%!assert (gsmbp_set (m, "g", 1.62).inv (0, pi/2, 0, 0), 1.2 * 1.62 * 0.5, 1e-15)
%!assert (gsmbp_set (m, struct ("l", 1, "g", 1)).par.l, 1)
%!assert (m.par.l, 0.5)
%!error <unknown parameter "G"> gsmbp_set (m, "G", 1)
%!test
%! n = m;
%! n.json.dependent = struct ("name", "mr", "expression", "rho*l", "value", 1, "unit", "kg");
%! fail ('gsmbp_set (n, "mr", 1)', ...
%!       "parameter mr is made of others, rho\\*l: expected one of these");
%!error <parameter g must be one finite number> gsmbp_set (m, "g", [1 2])
%!error <must be one finite number, found: \[\]> gsmbp_set (m, "g", [])
%!error <must be one finite number, found: NaN> gsmbp_set (m, "g", NaN)
%!error <must be one finite number, found: 1\+2i> gsmbp_set (m, "g", 1 + 2i)
%!error <PRE|pre> gsmbp_set (m, "J", -1)
