## [own, known] = gs.collocation.cost_term (m, name, weight, own)
## A term of the integrand in the unknowns of a point: NAME a state or an input, its square NAME^2,
## or a product NAME*NAME, added to OWN: linear (of each unknown of a point), products (rows [a, b,
## weight]). KNOWN: the words where NAME is none ({}: it is one).

function [own, known] = cost_term (m, name, weight, own)
  d = m.sizes;
  names = [m.states(:); m.inputs(:)];
  places = [1:d.nx, d.nx + d.nu + d.nlam + (1:d.nv)];
  parts = strtrim (strsplit (regexprep (name, '^(.*)\^2$', '$1*$1'), "*"));
  known = {};
  [there, k] = ismember (parts, names);
  if (! all (there) || numel (parts) > 2)
    known = names(:)';
  elseif (numel (parts) == 1)
    own.linear(places(k)) += weight;
  else
    k = sort (places(k), "descend");
    own.products(end+1,:) = [k, weight];
  endif
endfunction
