## p = gs.control.sampled_plant (who, p, o)
## The plant P with what its controller sees of it: F, H, the rates (with a period: the next values)
## of the states behind inputs that come late; H by the newest input, P.late by those before.
## P.plant: all of it as an ss object.

function p = sampled_plant (who, p, o)
  [n, nu] = size (p.B);
  h = o.period;
  p.h = h;
  p.count = 0;   # inputs on their way
  p.whole = 0;
  p.H1 = zeros (n, nu);
  if (h == 0)
    if (o.delay > 0)
      error ("%s: option delay: expected a period too: the delay is that of a computer", who);
    endif
    [p.F, p.H0] = deal (p.A, p.B);
    p.plant = ss (p.A, p.B, p.C, 0, "statename", p.states, "inputname", p.driven, ...
                  "outputname", p.measured);
    return;
  endif
  p.whole = floor (o.delay / h + 1e-9);
  part = o.delay - p.whole * h;
  if (part < 1e-9 * h)
    part = 0;
  endif
  p.F = expm (p.A * h);
  [E, old] = held (p.A, p.B, part);          # the end of the sample before
  [~, p.H0] = held (p.A, p.B, h - part);     # the rest of this one
  p.H1 = expm (p.A * (h - part)) * old;
  p.count = p.whole + (part > 0);
  [Fz, Hz] = gs.control.late_inputs (p);
  names = p.states;
  for k = 1:p.count
    names = [names; strcat(p.driven, sprintf ("_%d", k))];
  endfor
  p.plant = ss (Fz, Hz, [p.C, zeros(rows (p.C), p.count * nu)], 0, h, "statename", names, ...
                "inputname", p.driven, "outputname", p.measured);
endfunction

## x after the time t, of x and of a constant input
function [E, I] = held (A, B, t)
  [n, nu] = size (B);
  X = expm ([A, B; zeros(nu, n + nu)] * t);
  [E, I] = deal (X(1:n,1:n), X(1:n,n + 1:end));
endfunction
