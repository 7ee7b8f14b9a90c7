## axes = gs.machine.read_axes (who, m, s)
## The driven axes of the model M, a struct array in the order of the motion: the coordinate
## (name, number k, column among those planned, unit), its motor and gear ("": none), the
## numbers of the state and the input of the motor, the output that measures the coordinate, and
## in par the names of the parameters that the choice sets (R, L, K, J, B of the motor, n, eta,
## Tc, Jg of the gear).

function axes_ = read_axes (who, m, s)
  planned = (1:m.sizes.nu)';
  if (m.sizes.nlam > 0)
    planned = m.actuated(:);
  endif
  if (m.sizes.nlam > 0 && numel (planned) > 1)
    error (["%s: %s has loops and %d driven coordinates: expected an open chain, or a loop " ...
            "with one"], who, m.name, numel (planned));
  elseif (m.sizes.nq != m.sizes.nu)
    error ("%s: %s has coordinates that are not joint positions (Euler parameters)", who, m.name);
  elseif (! isempty (m.events) || ! isempty (m.controllers))
    error (["%s: %s has %s of its own: expected a scene without events and sampled devices"], ...
           who, m.name, strjoin ({m.controllers.name, m.events.device}, ", "));
  endif
  devices = gs.model.json_rows (m.json, "devices");
  motors = devices(cellfun (@(d) strcmp (d.entry, "dc_motor"), devices));
  found = cellfun (@(d) driven_by (who, m, d.name), motors);
  for i = 1:numel (planned)
    k = planned(i);
    one = struct ("coordinate", m.coordinates{k}, "k", k, "column", i, "unit", ...
                  m.units.coordinates{k});
    own = find (found == k);
    if (numel (own) != 1)
      error ("%s: the coordinate %s: expected one dc_motor that drives it, found %d", who, ...
             one.coordinate, numel (own));
    endif
    one.motor = motors{own}.name;
    one.gear = gear_of (devices, k);
    one.state = gs.given.places_of ([one.motor ".i"], m.states);
    one.input = gs.given.places_of ([one.motor ".v"], m.inputs);
    one.output = measured_by (who, m, one.coordinate);
    one.par = names_of (who, m, one, s);
    ratio_alone (who, m, one);
    axes_(i) = one;
  endfor
endfunction

## the coordinate on whose speed the current's rate depends
function k = driven_by (who, m, name)
  state = gs.given.places_of ([name ".i"], m.states);
  if (! state)
    error (["%s: dc_motor %s has no current among the states: expected a variant with " ...
            "inductance"], who, name);
  endif
  d = m.sizes;
  x = m.initial;
  v = zeros (d.nv, 1);
  before = m.rhs (0, x, v)(state);
  change = zeros (1, d.nu);
  for j = 1:d.nu
    y = x;
    y(d.nq+j) += 1;
    change(j) = abs (m.rhs (0, y, v)(state) - before);
  endfor
  [~, k] = max (change);
endfunction

## nothing but n between the motor and the coordinate: the back-EMF says it
function ratio_alone (who, m, one)
  [x, v] = deal (m.initial, zeros (m.sizes.nv, 1));
  y = x;
  y(m.sizes.nq + one.k) += 1;
  p = m.par;
  n = -(m.rhs (0, y, v) - m.rhs (0, x, v))(one.state) * p.(one.par.L) / p.(one.par.K);
  if (abs (n - p.(one.par.n)) > 1e-6 * abs (n))
    error (["%s: the coordinate %s: %s turns %.6g times as fast and %s is %.6g: expected " ...
            "nothing but the gear between them"], who, one.coordinate, one.motor, n, one.par.n, ...
           p.(one.par.n));
  endif
endfunction

function name = gear_of (devices, k)
  name = "";
  for d = devices
    if (strcmp (d{1}.entry, "lossy_gear") && isequal (d{1}.drives(:)', k))
      name = d{1}.name;
    endif
  endfor
endfunction

function name = measured_by (who, m, coordinate)
  list = gs.model.json_rows (m.json, "outputs");
  own = find (cellfun (@(o) strcmp (o.expression, coordinate), list), 1);
  if (isempty (own))
    error ("%s: no output measures the coordinate %s: add output(name, %s) to the scene", who, ...
           coordinate, coordinate);
  endif
  name = list{own}.name;
endfunction

## R, L, K, J, B of the motor and n, eta, Tc, Jg of the gear by the scene's names
function par = names_of (who, m, one, s)
  par = struct ("R", "", "L", "", "K", "", "J", "", "B", "", "n", "", "eta", "", "Tc", "", ...
                "Jg", "");
  for letter = {"R", "L", "K", "J", "B"}
    par.(letter{1}) = [one.motor "_" letter{1}];
  endfor
  if (isempty (one.gear))
    par.n = [one.motor "_n"];
  else
    for pair = {"n", "n"; "eta", "ef"; "Tc", "Tc"; "Jg", "J"}'
      par.(pair{1}) = [one.gear "_" pair{2}];
    endfor
  endif
  own = find (strcmp (s.axes(:,1), one.coordinate), 1);
  if (! isempty (own))
    given = s.axes{own,2};
    for name = fieldnames (given)'
      par.(name{1}) = given.(name{1});
    endfor
  endif
  for letter = {"R", "L", "K", "J", "B", "n"}
    if (! isfield (m.par, par.(letter{1})))
      error (["%s: the coordinate %s: %s of %s is no parameter of the scene that can be set " ...
              "(looked for %s): leave it out in the scene, or name it in axes, as {\"%s\", " ...
              "struct(\"%s\", \"name\")}"], who, one.coordinate, letter{1}, one.motor, ...
             par.(letter{1}), one.coordinate, letter{1});
    endif
  endfor
endfunction
