## gsmbp_workprecision on a scene without coordinates: the errors are those of the states.

function test_workprecision ()
  m = gsmbp_fixture ("switch_circuit");
  file = [tempname() ".png"];
  tidy = onCleanup (@() cellfun (@(e) unlink (strrep (file, ".png", e)), {".png", ".csv"}));
  said = evalc (["[w, best] = gsmbp_workprecision (m, [0; 0], [0 0.5 1], \"input\", 1, " ...
                 "\"rk4\", 0.05, \"dp853\", [1e-4 1e-9], \"seconds\", 0, \"file\", file);"]);
  gsmbp_check ("a figure is made", exist (file, "file") == 2);
  gsmbp_check ("the error is that of the states", [w.error] - [w.error_states], 0);
  ## A from closed form, B: 1 - exp (-10 t)
  fall = @(t) exp (-10 * t);
  exact = [5*(fall(0.2) - fall(0.4)), 1 - fall(0.5);
           5*(fall(0.7) - fall(0.9)) + 10*(1 - fall(0.3)), 1 - fall(1)];
  gsmbp_check ("the truth", w(1).reference(2:3,:) - exact, 1e-14);
  gsmbp_check ("the best of each error", ! isempty (best) && best(end).below < 1e-8 ...
               && strcmp (best(end).method, "dp853"));
  rows = regexp (said, '\n(?:rk4|dp853) [^\n]* - +(\S+)', "tokens");
  gsmbp_check ("they stand in their column", str2double ([rows{:}]) ./ [w.error_states] - 1, 1e-2);
  gsmbp_check ("and are told as theirs", any (strfind (said, "error of states below")));
end
