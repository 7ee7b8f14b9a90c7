## PUMA 560, three links: GSMBP against the reference's 25 states. Error: largest difference of an
## array over its largest entry.

function test_reference_puma3 ()
  m = gsmbp_fixture ("case_01a");
  weightless = gsmbp_set (m, "g", 0);
  [~, ref] = gsmbp_case ("01a_puma560_akb_3link");
  worst = zeros (1, 7);
  for s = ref.states'
    v = @(field) ne_numbers (s.(field));
    q = v("q"); u = v("qd");
    found = {m.mas(0, q), weightless.bia(0, q, u), m.bia(0, q, 0 * u), ...
             m.inv(0, q, u, v("qdd"), []), m.fwd(0, q, u, [], v("tau"))};
    wanted = {v("M"), v("c"), v("G"), v("tau_id"), v("qdd_fd")};
    E = m.ene (0, [q; u], []);
    found = [found, {E(1), E(2)}];
    wanted = [wanted, {v("kinetic"), v("potential")}];
    worst = max (worst, cellfun (@(a, b) max (abs (a - b)(:)) / max (abs (b(:))), found, wanted));
  end
  names = {"mass matrix", "velocity terms", "gravity", "inverse dynamics", "forward dynamics", ...
           "kinetic energy", "potential energy"};
  for k = 1:7
    gsmbp_check (["puma3: " names{k} ", 25 states"], worst(k), 1e-13);
  end
end
