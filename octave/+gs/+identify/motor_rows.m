## w = gs.identify.motor_rows (who, m, d, w, motors)
## The regression W, whose efforts b are known, with motors whose currents and voltages were
## measured instead of efforts: their effort K*ratio*i goes to the left, and each has rows of its
## own, v = R*i + K*ratio*u (+ L*i'); w.group: which effort or voltage a row is.

function w = motor_rows (who, m, d, w, motors)
  n = m.sizes.nu;
  for k = 1:numel (motors)
    a = motors(k);
    c = find (strcmp (m.coordinates, a.coordinate));
    i = column_of (who, d.other, a.current, "current", k);
    v = column_of (who, d.other, a.voltage, "voltage", k);
    nt = numel (d.t);
    at = columns (w.Y) + 1;
    w.Y(c:n:nt*n,at) = -a.ratio * i;
    w.b(c:n:nt*n) = -w.r(c:n:nt*n);
    new = zeros (nt, at + 1 + a.inductance);
    new(:,at) = a.ratio * d.u(:,c);
    new(:,at+1) = i;
    names = {"K", "R"};
    units = {"N*m/A", "ohm"};
    if (a.inductance)
      new(:,at+2) = column_of (who, d.other_d, a.current, "current", k);
      [names{3}, units{3}] = deal ("L", "H");
    endif
    w.Y(end,columns (new)) = 0;
    w.Y = [w.Y; new];
    w.b = [w.b; v];
    w.group = [w.group; repmat(n + k, nt, 1)];
    w.names = [w.names; strcat(a.coordinate, "_", names)'];
    w.units = [w.units; units'];
    w.kind = [w.kind, repmat({"motor"}, 1, numel (names))];
    w.p = [w.p; NaN(numel (names), 1)];
  endfor
endfunction

function x = column_of (who, list, name, what, k)
  if (! isfield (list, name))
    error ("%s: option motors: %s of motor %d: unknown column %s", who, what, k, ...
           gs.text.nearest_word (name, fieldnames (list)'));
  endif
  x = list.(name)(:);
endfunction
