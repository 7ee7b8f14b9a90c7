## m = gsmbp__handles (m)
## The constants m.cst of the parameters m.par and the handles that use them.

function m = gsmbp__handles (m)
  f = m.module;
  m.cst = f ("pre", struct2array_of (m.par));
  cst = m.cst;
  has = @(name) any (strcmp (m.subroutines, name));
  calls.kin = @(t, q, u) f ("kin", cst, t, q, u);
  calls.inv = @(t, q, u, ud, varargin) f ("inv", cst, t, q, u, ud, varargin{:});
  calls.mas = @(t, q) f ("mas", cst, t, q);
  calls.reg = @(t, q, u, ud, varargin) f ("reg", cst, t, q, u, ud, varargin{:});
  calls.bia = @(t, q, u, varargin) f ("bia", cst, t, q, u, varargin{:});
  calls.fwd = @(t, q, u, varargin) f ("fwd", cst, t, q, u, varargin{:});
  calls.con = @(t, q, varargin) f ("con", cst, t, q, varargin{:});
  calls.inl = @(t, q, u, ud, varargin) f ("inl", cst, t, q, u, ud, varargin{:});
  calls.lin = @(t, q, u, ud, varargin) f ("lin", cst, t, q, u, ud, varargin{:});
  calls.rhs = @(t, x, varargin) f ("rhs", cst, t, x, varargin{:});
  calls.acc = @(t, x, varargin) f ("acc", cst, t, x, varargin{:});
  calls.acd = @(t, x, v, way) f ("acd", cst, t, x, v, way);
  calls.tan = @(t, x) f ("tan", cst, t, x);
  calls.prj = @(t, x) f ("prj", cst, t, x);
  calls.jac = @(t, x, varargin) f ("jac", cst, t, x, varargin{:});
  calls.out = @(t, x, varargin) f ("out", cst, t, x, varargin{:});
  calls.cmd = @(t, qj, varargin) f ("cmd", cst, t, qj, varargin{:});
  calls.cmx = @(t, qj, varargin) f ("cmx", cst, t, qj, varargin{:});
  calls.ctl = @(k, t, y, xk, varargin) f ("ctl", cst, k, t, y, xk, varargin{:});
  calls.evt = @(t, x, v, mode) f ("evt", cst, t, x, v, mode);
  calls.rst = @(t, x, v, mode, k) f ("rst", cst, t, x, v, mode, k);
  calls.clo = @(t, qj) f ("clo", cst, t, qj);
  calls.ene = @(t, x, varargin) f ("ene", cst, t, x, varargin{:});
  calls.ske = @(t, q) f ("ske", cst, t, q);
  calls.inv_v = @(t, q, u, ud, varargin) f ("inv_v", cst, t, q, u, ud, varargin{:});
  calls.mas_v = @(t, q) f ("mas_v", cst, t, q);
  calls.bia_v = @(t, q, u, varargin) f ("bia_v", cst, t, q, u, varargin{:});
  calls.fwd_v = @(t, q, u, varargin) f ("fwd_v", cst, t, q, u, varargin{:});
  calls.rhs_v = @(t, x, varargin) f ("rhs_v", cst, t, x, varargin{:});
  for [call, name] = calls
    if (has (name))
      m.(name) = call;
    endif
  endfor
endfunction

function values = struct2array_of (par)
  values = cellfun (@double, struct2cell (par));
endfunction
