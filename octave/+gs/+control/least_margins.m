## g = gs.control.least_margins (law)
## The margins of the control loop of the controller LAW, the worst of its inputs: a struct of
## phase_margin [rad], gain_margin, Ms, delay_margin [s]; what has no bound is 1e6.  An unstable
## loop is an error.

function g = least_margins (law)
  r = gsmbp_loop (law);
  refuse_unstable (law);
  g = struct ("phase_margin", min ([r.phase, 1e6]), "gain_margin", min ([r.gain, 1e6]), ...
              "Ms", max ([r.Ms]), "delay_margin", min ([r.delay, 1e6]));
endfunction

## The delay of a continuous controller is no pole: it is compared with what the loop bears without
## it.
function refuse_unstable (law)
  [~, worst] = gs.control.closed_poles (law);
  if (worst >= 0)
    at = {sprintf("%g 1/s", worst), sprintf("|z| = %.9g", 1 + worst)}{1 + (law.period > 0)};
    error ("the loop is unstable (a pole at %s): it has no margins", at);
  endif
  if (law.period == 0 && law.delay > 0)
    at_once = law;
    at_once.delay = 0;
    bears = min ([gsmbp_loop(at_once).delay]);
    if (law.delay >= bears)
      error ("the loop is unstable (it bears a delay of %g s): it has no margins", bears);
    endif
  endif
endfunction
