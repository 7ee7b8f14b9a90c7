## Where devices start: filters and observers settled, starts made of parameters with their values,
## and one error where a device cannot be, in every calculation that takes a state.

function test_start_devices ()
  m = gsmbp_fixture ("start_devices");
  at = @(m, name) m.initial(strcmp (m.states, name));
  settled (m, at, 0.3);
  gsmbp_check ("a start that the scene gives stays", at (m, "given.y") - 0.02, 0);
  gsmbp_check ("a start made of a parameter, Pa", at (m, "ram.p1") - 5e6, 0);
  n = gsmbp_set (m, "phi0", -0.2, "pstart", 6e6);
  settled (n, at, -0.2);
  gsmbp_check ("it follows the parameter, Pa", at (n, "ram.p1") - 6e6, 0);
  own = m;
  own.initial(1) = 0.7;
  own = gsmbp_set (own, "phi0", -0.2);
  gsmbp_check ("a start of the user's own stays", own.initial(1) - 0.7, 0);
  impossible (m);
  outside ();
  loops (gsmbp_fixture ("fluid_hydraulic"));
end

## the first 1e-5 s: nothing that only follows the mechanism jumps
function settled (m, at, phi)
  gsmbp_check ("observer, rad", at (m, "observer.xe") - phi, 1e-12);
  gsmbp_check ("sensor of second order, V", [at(m, "fast.y") - 2 * phi, at(m, "fast.v")], 1e-12);
  gsmbp_check ("sensor of first order, V", at (m, "slow.y") - 0.1, 1e-12);
  gsmbp_check ("filter of a derivative, rad", at (m, "law.xd") - (0.05 - phi), 1e-12);
  gsmbp_check ("integrals, V", [at(m, "law.I"), at(m, "lag.I")], 0);
  own = m.json.settled;
  rates = m.rhs (0, m.initial, zeros (m.sizes.nv, 1));
  gsmbp_check ("their rates vanish, 1/s", rates(own) ./ m.nominal(own), 1e-9);
  x = gsmbp_assemble (m, m.initial(1:m.sizes.nq) + 0.05);
  gsmbp_check ("gsmbp_assemble settles them, rad", ...
               x(strcmp (m.states, "observer.xe")) - phi - 0.05, 1e-12);
end

## a piston beyond its stroke where the scene starts is told when the model is built
function outside ()
  lastwarn ("");
  m = gsmbp_fixture ("trim_hydraulic");
  gsmbp_check ("a start within the stroke: no warning", numel (lastwarn ()), 0);
  folder = m.directory;
  warning ("off", "local");
  gsmbp_build ("trim_hydraulic", "directory", folder, "parameters", struct ("C_h", 0.2));
  said = lastwarn ();
  gsmbp_check ("one beyond it", ! any (strfind (said, ...
               "trim_hydraulic starts outside a margin: C: piston within its stroke, rod out")), 0);
end

function impossible (m)
  bad = m.initial;
  bad(strcmp (m.states, "ram.p1")) = 3e7;
  text = 'ram: pressure of the cap side below the supply''s: expected above 0, found ';
  calls = {@(m, x) gsmbp_simulate(m, x, [0, 1e-3]), @(m, x) gsmbp_linear(m, 0, x)};
  for call = calls
    said = gsmbp_complaint (@() call{1}(m, bad));
    gsmbp_check (["refused: " said], ...
                 any (strfind (said, [text "-1e+07 (ram.p1 = 3e+07, ram_ps = 2e+07); "])) ...
                 && any (strfind (said, '"project"')));
    low = gsmbp_set (m, "ram_ps", 4.5e6);
    said = gsmbp_complaint (@() call{1}(low, low.initial));
    gsmbp_check (["refused after gsmbp_set: " said], ...
                 any (strfind (said, "(ram.p1 = 5e+06, ram_ps = 4.5e+06)")));
  end
  lastwarn ("", "");
  r = gsmbp_simulate (m, bad, [0, 1e-3], "start", "project", "method", "cvode", "rtol", 1e-6);
  gsmbp_check ("\"project\" takes it", isfinite (r.x(:)));
  gsmbp_check ("... and the run says the same", any (strfind (lastwarn (), text)));
  edge = m.initial;
  edge(strcmp (m.states, "ram.p1")) = m.par.ram_ps * (1 + 1e-9);
  r = gsmbp_simulate (m, edge, [0, 1e-4], "method", "cvode", "rtol", 1e-6);
  gsmbp_check ("at the margin but for rounding: taken", isfinite (r.x(:)));
end

## a run goes on from where another ended
function loops (m)
  x = gsmbp_simulate (m, m.initial, [0, 0.05], "method", "cvode", "rtol", 1e-6).x(end,:);
  r = gsmbp_simulate (m, x, [0.05, 0.1], "method", "cvode", "rtol", 1e-6);
  gsmbp_check ("goes on", isfinite (r.x(:)));
end
