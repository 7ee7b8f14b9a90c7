## gs.given.check_model (who, m)
## An error of WHO unless M is a model of gsmbp_build whose parameters are those of its constants.

function check_model (who, m)
  if (! (isstruct (m) && isscalar (m) && all (isfield (m, {"module", "sizes", "subroutines"}))))
    error ("%s: argument m: expected a model of gsmbp_build, found %s", who, ...
           gs.text.shown_value (m));
  endif
  if (isfield (m, "applied") && ! same (struct2cell (m.par), struct2cell (m.applied)))
    refuse_parameters (who, m);
  endif
endfunction

## isequal takes a fifth of the time of a short run
function is = same (now, before)
  is = numel (now) == numel (before) && all (cellfun ("isclass", now, "double")) ...
       && all (cellfun ("numel", now) == 1) && all ([now{:}] == [before{:}]);
endfunction

## m.par was changed by hand: the model calculates with what it was
function refuse_parameters (who, m)
  names = union (fieldnames (m.applied), fieldnames (m.par), "stable")';
  for k = names
    [now, before] = deal (value_of (m.par, k{1}), value_of (m.applied, k{1}));
    if (! isequal (now, before))
      error (["%s: %s: m.par.%s is %s, but the model calculates with %s: change it with " ...
              "gsmbp_set"], who, m.name, k{1}, shown (now), shown (before));
    endif
  endfor
endfunction

function value = value_of (par, name)
  value = [];
  if (isfield (par, name))
    value = par.(name);
  endif
endfunction

function text = shown (value)
  text = gs.text.shown_value (value);
  if (isempty (value))
    text = "none";
  elseif (isa (value, "double") && isscalar (value))
    text = sprintf ("%.16g", value);
  endif
endfunction

%!shared m
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%!test gs.given.check_model ("f", gsmbp_set (m, "g", 1));
%!test
%! m.par.g = 1;
%! fail ('gs.given.check_model ("f", m)', ...
%!       "f: motor_pendulum: m.par.g is 1, but the model calculates with 9.8.*gsmbp_set");
%!test
%! m.par.G = 1;
%! fail ('gs.given.check_model ("f", m)', "m.par.G is 1, but the model calculates with none");
