## list = gs.identify.negative_values (m, s, e)
## The numbers of the estimates E that cannot be negative: base parameters of the model M that are
## sums, with factors above 0, of masses, moments of inertia and frictions; dry and viscous
## friction, rotors, motor constants.  S: the standard parameters of M
## (gs.identify.standard_parameters).

function list = negative_values (m, s, e)
  positive = ! cellfun (@isempty, regexp (s.names(:)', '_(m|Ixx|Iyy|Izz|friction|rotor)$'));
  fine = all (s.K >= 0, 2) & ! any (s.K(:,! positive), 2) & any (s.K, 2);
  names = gs.given.names_and_units (m.json.base_parameters);
  names = names(fine);
  list = find (ismember (e.names, names) | ismember (e.kind, {"coulomb", "viscous", "rotor", ...
                                                              "motor"}))';
endfunction
