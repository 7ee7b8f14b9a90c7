## g = gsmbp__least_margins (law)
## The margins of the control loop of the controller LAW, the worst of its inputs: a struct of
## phase_margin [rad], gain_margin, Ms, delay_margin [s]; what has no bound is 1e6.  An unstable
## loop is an error.

function g = gsmbp__least_margins (law)
  r = gsmbp_loop (law);
  if (law.period == 0 && law.delay == 0)
    late = max (real (gsmbp__closed_poles (law)));
    if (late >= 0)
      error ("the loop is unstable (a pole at %g 1/s): it has no margins", late);
    endif
  endif
  g = struct ("phase_margin", min ([r.phase, 1e6]), "gain_margin", min ([r.gain, 1e6]), ...
              "Ms", max ([r.Ms]), "delay_margin", min ([r.delay, 1e6]));
endfunction
