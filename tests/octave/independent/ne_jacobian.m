## H = ne_jacobian (K): all constraints of a model on its joint speeds, from k = ne_rows (...):
## loops, then what is given on the speeds. [H, GAMMA] = ne_jacobian (K): and H ud = GAMMA.

function [H, gamma] = ne_jacobian (k)
  H = [k.L * (k.J \ k.E); k.U];
  if (nargout > 1)
    gamma = [k.gamma_loop - k.L * (k.J \ k.gamma); k.gamma_user];
  end
end
