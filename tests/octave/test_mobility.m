## gsmbp_mobility names the components of reactions that the motion determines; where the loop is
## cut does not matter: components that are called unique are equal in all cuts (react_cut_b,
## react_cut_c, react_link are one four-bar), rows that were left out count.

function test_mobility ()
  folded ();
  names = {"react_cut_b", "react_cut_c", "react_link"};
  told = cell (1, 3);
  for i = 1:3
    m = gsmbp_fixture (names{i});
    r = gsmbp_mobility (m, closed (m));
    told{i} = r.reactions;
    gsmbp_check ([names{i} ...
                    ": every joint has force in the plane and moment about its axis unique"], ...
      all (arrayfun (@(one) isequal (one.unique, {"x", "y", "mz"}) ...
                       && isequal (one.not_unique, {"z", "mx", "my"}), r.reactions)));
  endfor
  for i = 2:3
    for one = told{i}
      k = find (strcmp (one.joint, {told{1}.joint}));
      gsmbp_check (sprintf ("%s: joint %s as in %s", names{i}, one.joint, names{1}), ...
                   isempty (k) || isequal (one.unique, told{1}(k).unique));
    endfor
  endfor
  m = gsmbp_fixture ("redundant_fourbar");
  r = gsmbp_mobility (m, closed (m));
  gsmbp_check ("tilted four-bar: no component along the axes of ground, no multiplier", ...
               ! any (r.unique) && all (arrayfun (@(one) isempty (one.unique), r.reactions)));
  text = evalc ("gsmbp_mobility (m, closed (m))");
  gsmbp_check ("and this is printed", ...
               ! isempty (strfind (text, ...
                                   ["reaction in A (a): not unique: x, y, z, mx, my, mz; " ...
                                    "unique: none"])));
  info = m.json.subroutines(strcmp ({m.json.subroutines.name}, "REDUNDANT_FOURBAR_RHS")).info;
  gsmbp_check ("INFO of RHS in sentences", ...
               any ([info.code] == 1) ...
                 && ! isempty (strfind (info([info.code] == 2).meaning, ...
                                 "constraints are dependent")));
  gsmbp_check ("what all leaves out", ...
               ! isempty (strfind (m.json.left_out(strcmp ({m.json.left_out.request}, ...
                                       "command")).reason, "no actuators")));
  marks (gsmbp_fixture ("react_change"));
  singular ();
  once (gsmbp_fixture ("redundant_bricard"));
end

## a crank as long as its rod, folded: the row of y is a rounding error there, no direction
function folded ()
  m = gsmbp_set (gsmbp_fixture ("sensitivity_crank"), "l1", 0.5);
  r = gsmbp_mobility (m, [pi/2; -pi; zeros(m.sizes.nx - 2, 1)]);
  gsmbp_check ("a row that has vanished has no rank", [r.rank, r.mobility] - [1, 2], 0);
  r = gsmbp_mobility (m, [pi/3; -2*pi/3; 0.5; zeros(m.sizes.nx - 3, 1)]);
  gsmbp_check ("... elsewhere it has", [r.rank, r.mobility] - [2, 1], 0);
end

function x = closed (m)
  x = gsmbp_assemble (m, m.json.initial);
end

## what is said beside results, in a scene that starts in a change position
function marks (m)
  for one = gsmbp_mobility (m, gsmbp_assemble (m, [0.7; -0.7; 0.7], "hold", "q1")).reactions
    gsmbp_check ([one.joint ...
                    " from a change position: force in the plane, moment about the axis"], ...
                 isequal (one.unique, {"x", "y"}) || isequal (one.unique, {"x", "y", "mz"}));
  end
  want = cellfun (@isempty, regexp (m.outputs(:)', '\.(z|mx|my)$|^sum_z$'));
  gsmbp_check ("m.unique.outputs: expressions in reactions, too", isequal (m.unique.outputs, want));
  r = gsmbp_inverse (m, gsmbp_plan ("quintic", [0.7, 1.2], [0, 1]), [0, 1], ...
                     "guess", [0.7; -0.7; 0.7]);
  gsmbp_check ("gsmbp_inverse from a guess in the change position goes on", ...
               isfinite (gsmbp_inverse (m, gsmbp_plan ("quintic", [0.7, 1.2], [0, 1]), 0).q));
  gsmbp_check ("gsmbp_inverse: unique beside lambda", isequal (r.unique, m.unique.multipliers));
  r = gsmbp_trim (m, [-pi/2; pi/2; -pi/2; 0; 0; 0]);
  gsmbp_check ("gsmbp_trim: unique beside lambda", isequal (size (r.unique), size (r.lambda)));
end

## linear models, modes and equilibria say where constraints are not as independent as elsewhere
function singular ()
  m = gsmbp_set (gsmbp_fixture ("case_03a"), "la", 0.3, "lc", 0.3, "lb", 0.6, "ld", 0.6);
  rise = [-pi/2; pi/2; -pi/2; 0; 0; 0];   # hanging
  for flat = [true, false]
    x = {rise, zeros(6, 1)}{1 + flat};
    for call = {@() gsmbp_linear(m, 0, x).a, @() gsmbp_modes(m, x).x, ...
                @() gsmbp_trim(m, x, [], "hold", "theta", "free", "tau_a").x}
      lastwarn ("", "");
      value = call{1}();
      [text, id] = lastwarn ();
      says = strcmp (id, "gsmbp:singular") && ! isempty (strfind (text, "a change point"));
      what = sprintf ("%s, %s: ", func2str (call{1}), {"hanging", "flat"}{1 + flat});
      gsmbp_check ([what text], says == flat);
    end
  end
end

## lost rank of a redundant scene is no warning, whatever is called
function once (m)
  x = gsmbp_assemble (m, m.initial);
  said = 0;
  warning ("on", "gsmbp:rank", "local");
  for k = 1:4
    lastwarn ("", "");
    m.kin (0, x(1:m.sizes.nq), x(m.sizes.nq+1:end));
    m.con (0, x(1:m.sizes.nq), x(m.sizes.nq+1:end));
    m.acc (0, x, zeros (m.sizes.nv, 1));
    [~, id] = lastwarn ();
    said += strcmp (id, "gsmbp:rank");
  end
  gsmbp_check (sprintf ("m.acc of %s: the warning came %d times of four", m.name, said), said == 0);
end
