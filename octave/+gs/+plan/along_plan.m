## [qj, xi] = gs.plan.along_plan (who, m, pp, planned, times, side, guess, devices)
## The motion of all of M along the plan PP of the PLANNED coordinates at TIMES, one after the
## other: QJ (nu,1+order,times), loops closed from GUESS on; SIDE: which limit to take where the
## plan breaks. With DEVICES, their states at the first time, XI has a column of states for each
## time, internal ones by their own rates.

function [qj, xi] = along_plan (who, m, pp, planned, times, side, guess, devices)
  d = m.sizes;
  carry = nargin > 7;
  if (! carry)
    devices = zeros (d.nx - d.nq - d.nu, 1);
  endif
  [breaks, coefficients] = unmkpp (pp);
  [qj, xi, done, text, verdict] = ...
      m.module ("planned", m.cst, m.nominal, times, side, m.order, planned, breaks, ...
                coefficients, guess, devices, carry);
  if (verdict == 3)   # margins that are not kept where it began say more
    last = max (done, 1);
    [~, ~, ~, margins] = m.cmx (times(last), qj(:,:,last), xi(:,last));
    broken = m.margins(! (margins > 0))(:)';
    if (! isempty (broken))
      text = [text, "; not kept at the first of these times: ", strjoin(broken, "; ")];
    endif
  endif
  if (verdict)
    error ("gsmbp:start", "%s: %s: %s", who, m.name, text);
  endif
endfunction
