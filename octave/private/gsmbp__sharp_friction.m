## gsmbp__sharp_friction (who, m, r)
## A warning of WHO where an implicit method made the run R of the model M, and a port with events
## whose friction falls from its breakaway within a speed vs that the method cannot resolve: above
## it a fast mode grows, which an implicit step damps where the tolerance lets it.  By counts of
## events (a block on a spring, radau and cvode, vs and atol from 1e-3 to 1e-12) that is where atol
## of the speed is vs or more, or vs is below 5e-9 of the nominal speed.

function gsmbp__sharp_friction (who, m, r)
  ports = find (strcmp ({m.events.kind}, "stick"));
  if (! any (strcmp (r.stats.method, {"radau", "cvode"})) || isempty (r.events.t) ...
      || isempty (ports))
    return;
  endif
  [rows, ~, ~, held] = m.hld (r.t(end), r.x(end,:)', r.v(end,:)');
  speeds = m.sizes.nq + (1:m.sizes.nu);
  for k = ports
    row = abs (rows(k,:));
    vs = held(2,k);
    [atol, nominal] = deal (row * r.stats.atol(speeds)(:), row * m.nominal(speeds)(:));
    if (any (strcmp (r.events.name, m.events(k).name)) ...
        && vs > 0 && (vs <= atol || vs < 5e-9 * nominal))
      warning ("gsmbp:events", ["%s: %s: %s falls from its breakaway within vs = %.3g, the " ...
                                "tolerance of its speed (atol) is %.3g: %s may report events " ...
                                "that are none; expected atol below vs, and vs at least %.3g; " ...
                                "remedy: method \"auto\" or \"dp853\", or a larger vs"], ...
               who, m.name, m.events(k).name, vs, atol, r.stats.method, ...
               5e-9 * nominal);
    endif
  endfor
endfunction
