## yes = gs.control.ideal_efforts (m, o)
## Whether the model M is an open chain whose inputs (of options O, or all) are the efforts on its
## speeds, in their order, at once: INV gives them then.

function yes = ideal_efforts (m, o)
  n = m.sizes.nu;
  yes = m.sizes.nlam == 0 && m.sizes.nx == 2 * n ...
        && all (ismember ({"mas", "jac"}, m.subroutines));
  names = gs.given.asked_names (o.inputs);
  if (isempty (names))
    names = m.inputs;
  endif
  k = gs.given.places_of (names, m.inputs);
  yes = yes && numel (k) == n && all (k);
  if (yes)
    [~, B] = m.jac (0, m.initial, zeros (m.sizes.nv, 1));
    E = m.mas (0, m.initial(1:n)) * B(n + (1:n),k);
    yes = all ((abs (E - eye (n)) <= 1e-9)(:));
  endif
endfunction
