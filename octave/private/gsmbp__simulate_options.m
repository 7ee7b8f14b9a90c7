## table = gsmbp__simulate_options (drift)
## Return the options of gsmbp_simulate: name, default (DRIFT for "drift"), kind. The default NaN of
## rtol is 1e-10; no user can give it, so that a tolerance that is not used can be reported.

function table = gsmbp__simulate_options (drift)
  table = {"method", "dp853", {"dp853", "rk4", "cvode", "radau", "gauss", "auto"}
           "step", [], "any"
           "rtol", NaN, "tolerance"
           "atol", [], "any"
           "maxstep", 0, "nonnegative"
           "maxsteps", 0, "whole"
           "timeout", 0, "nonnegative"
           "maxorder", [], "any"
           "loops", "", "any"
           "projection", [], "flag"
           "drift", drift, "flag"
           "input", [], "any"
           "motion", [], "any"
           "gain", [], "any"
           "reference", [], "any"
           "limits", [], "any"
           "breaks", [], "list"
           "memory", [], "list"
           "samples", true, "flag"
           "modes", [], "list"
           "audit", [], "positive"
           "sensitivity", {}, "names"
           "fixed", {}, "names"
           "dx0", [], "numbers"
           "start", "check", {"check", "project"}};
endfunction
