## r = gs.run.run_ipopt (who, m, p, o)
## A problem solved by Ipopt (host/ipopt) in the module of the model M.  P: a struct with x0, low,
## high; glow, ghigh (of the constraints); jac, hess (places of the entries, two columns; hess []:
## Ipopt's own by limited memory); f (what, x, factor, lambda) gives "f", "grad", "g", "jac", "hess"
## as columns.  O: tolerance, iterations, evaluations,
## seconds, and options, more words of Ipopt with their values. R: x, J, g, lambda, zl, zu, status
## (of Ipopt), iterations, ended (a sentence), solved, limit, infeasible, text (the last error of
## f), interrupted (x is the last iterate then, multipliers are NaN).

function r = run_ipopt (who, m, p, o)
  r = m.module ("ipopt", gs.model.host_library (who, m, "ipopt"), p, o);
  if (r.interrupted)
    r.ended = gs.run.stopped_text ("interrupted");
  endif
endfunction
