## yes = gs.identify.bodies_near (s, e)
## Whether bodies have the estimates E of all base parameters: the standard parameters that are
## nearest to those of the model (S: gs.identify.standard_parameters), by their sizes, are those of
## bodies. Where not, there may be others.

function yes = bodies_near (s, e)
  size_ = abs (s.nominal);
  D = diag (size_ + 0.01 * mean (size_) + realmin);
  base = strcmp (e.kind, "base");
  x = s.nominal + D * (pinv (s.K * D) * (e.p(base) - s.K * s.nominal));
  first = find (! cellfun (@isempty, regexp (s.names, '_hx$')))' - 1;
  yes = all (x(setdiff (1:numel (x), first + (0:9)')) >= 0);
  for k = first
    l = eig (gs.identify.pseudo_inertia (x(k:k+9)));
    yes &= min (l) >= -1e-9 * max (abs (l));
  endfor
endfunction
