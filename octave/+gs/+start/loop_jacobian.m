## [H, K, phi] = gs.start.loop_jacobian (m, t, x)
## Return PHI of the constraints on the coordinates of the model M at the time T and the state X,
## the Jacobian H of its rate by the speeds u, and K of q' = K*u.

function [H, K, phi] = loop_jacobian (m, t, x)
  d = m.sizes;
  q = x(1:d.nq);
  e = eye (d.nu);
  [phi, ~, H, ~, ~] = m.con (t, q, e(:,1));
  rows = setdiff (1:d.nlam, m.speed_rows);   # the others have no phi
  [phi, H] = deal (phi(rows), H(rows,:));
  if (d.nq == d.nu && ! any (strcmp (m.subroutines, "kin")))
    K = e;
    return;
  endif
  for j = d.nu:-1:1
    K(:,j) = m.kin (t, q, e(:,j));
  endfor
endfunction
