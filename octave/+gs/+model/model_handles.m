## m = gs.model.model_handles (m)
## m = gs.model.model_handles (m, calls)
## The constants m.cst of the parameters m.par; the handles that use them, all or those of CALLS;
## m.applied: the parameters that these have.

function m = model_handles (m, calls)
  f = m.module;
  m.cst = f ("pre", struct2array_of (m.par));
  m.applied = m.par;
  cst = m.cst;
  ## what is wrong with the arguments, or that a subroutine was not emitted, the module says
  if (nargin < 2)
    calls = f ("calls")';
  endif
  for name = calls
    call = name{1};
    m.(call) = @(varargin) f (call, cst, varargin{:});
  endfor
endfunction

function values = struct2array_of (par)
  values = cellfun (@double, struct2cell (par));
endfunction
