## gsmbp_mobility names the components of reactions that the motion determines; where the loop is cut does not matter: components that are called unique
## are equal in all cuts (react_cut_b, react_cut_c, react_link are one four-bar), rows that were left out count.

function test_mobility ()
  names = {"react_cut_b", "react_cut_c", "react_link"};
  told = cell (1, 3);
  for i = 1:3
    m = gsmbp_fixture (names{i});
    r = gsmbp_mobility (m, closed (m));
    told{i} = r.reactions;
    gsmbp_check ([names{i} ": every joint has force in the plane and moment about its axis unique"], ...
      all (arrayfun (@(one) isequal (one.unique, {"x", "y", "mz"}) && isequal (one.not_unique, {"z", "mx", "my"}), r.reactions)));
  endfor
  for i = 2:3
    for one = told{i}
      k = find (strcmp (one.joint, {told{1}.joint}));
      gsmbp_check (sprintf ("%s: joint %s as in %s", names{i}, one.joint, names{1}), isempty (k) || isequal (one.unique, told{1}(k).unique));
    endfor
  endfor
  m = gsmbp_fixture ("redundant_fourbar");
  r = gsmbp_mobility (m, closed (m));
  gsmbp_check ("tilted four-bar: no component along the axes of ground, no multiplier", ! any (r.unique) && all (arrayfun (@(one) isempty (one.unique), r.reactions)));
  text = evalc ("gsmbp_mobility (m, closed (m))");
  gsmbp_check ("and this is printed", ! isempty (strfind (text, "reaction in A (a): not unique: x, y, z, mx, my, mz; unique: none")));
  info = m.json.subroutines(strcmp ({m.json.subroutines.name}, "REDUNDANT_FOURBAR_RHS")).info;
  gsmbp_check ("INFO of RHS in sentences", any ([info.code] == 1) && ! isempty (strfind (info([info.code] == 2).meaning, "constraints are dependent")));
  gsmbp_check ("what all leaves out", ! isempty (strfind (m.json.left_out(strcmp ({m.json.left_out.request}, "command")).reason, "no actuators")));
end

function x = closed (m)
  x = gsmbp_assemble (m, m.json.initial);
end
