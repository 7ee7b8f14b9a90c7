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
  refused (gsmbp_hand ("motor_pendulum"));
  once (gsmbp_hand ("motor_pendulum"));
  far_off (gsmbp_hand ("motor_pendulum"));
end

## steps that are not stable: measured and told, but the best of nothing and not drawn
function far_off (m)
  m = gsmbp_set (m, "L_a", 1e-4);
  warning ("off", "gsmbp:stiff", "local");
  file = [tempname() ".svg"];
  tidy = onCleanup (@() cellfun (@(e) unlink (strrep (file, ".svg", e)), {".svg", ".csv"}));
  [w, best] = gsmbp_workprecision (m, [0.2 0 0], [0 0.02 0.04], "input", 3, "rk4", [2e-3, 1e-4], ...
                                   "dp853", 1e-6, "seconds", 0, "print", false, "file", file);
  gsmbp_check (sprintf ("far off by %.1e", w(1).error), w(1).error > 1e3 && isfinite (w(1).error));
  gsmbp_check ("it is the best of nothing", ! isempty (best) && all ([best.below] < 1) ...
                                            && all ([best.error] < 0.1));
  table = csvread (strrep (file, ".svg", ".csv"), 1, 0);
  gsmbp_check ("it is not drawn", rows (table) == 2 && all (table(:,2:end)(:) < 0.1 ...
                                                            | isnan (table(:,2:end)(:))));
  [~, best] = gsmbp_workprecision (m, [0.2 0 0], [0 0.04], "input", 3, "rk4", 2e-3, "seconds", ...
                                   0, "dp853", [], "print", false);
  gsmbp_check ("nothing is the best where all are far off", isempty (best));
end

## before anything is measured, in the name of the function
function refused (m)
  few = {"rk4", 1e-3, "dp853", 1e-6};
  wrong = {[1 0 0], {"file", "x.foo"}, "option file: the file must end in .png"
           [1 0 0], {"rk4", -1}, "option rk4: expected steps above 0, found -1"
           [1 0 0], {"rk4", [1 2; 3 4]}, "option rk4: expected a vector of finite numbers"
           [1 0 0], {"rk4", 1e-12}, "option rk4: 0.1 s in steps of 1e-12 s"
           [1 0 0], {"gauss", [1e-3, 0]}, "option gauss: expected steps above 0, found 0"
           [1 0 0], {"dp853", [1e-6, 2]}, "option dp853: expected tolerances above 0 and below 1"
           [1 0 0], {"index2", 1e-6}, "option index2: motor_pendulum has no loops"
           [1 NaN 0], few, "argument x0(2), q_d is not finite: NaN"
           [1 0 0], [few, {"input", NaN}], "input: expected 1 finite numbers"};
  for row = wrong'
    begun = cputime ();
    said = gsmbp_complaint (@() gsmbp_workprecision (m, row{1}, [0 0.1], row{2}{:}, "seconds", ...
                                                     20, "print", false));
    gsmbp_check (["refused at once: " said], cputime () - begun < 10 ...
                 && strncmp (said, ["gsmbp_workprecision: " row{3}], 21 + numel (row{3})));
  end
  message = "";
  said = evalc (["message = gsmbp_complaint (@() gsmbp_workprecision (m, [1 0 0], [0 1e4], " ...
                 "few{:}, \"timeout\", 0.1));"]);
  gsmbp_check (["out of time: " message], isempty (said) ...
               && ! isempty (strfind (message, "the reference, in quad precision, ended at t =")));
end

## what all runs warn of
function once (m)
  m = gsmbp_set (m, "L_a", 1e-5);
  o = {m, [0.2 0 0], [0 0.1], "input", 3, "rk4", [1e-4, 2e-5], "dp853", [1e-4, 1e-6], "seconds", ...
       0.05, "print", false};
  said = evalc ("gsmbp_workprecision (o{:});");
  gsmbp_check (["stiffness is told once: " strtok(said, "\n")], ...
               strncmp (said, "warning: gsmbp_workprecision: ", 30) ...
               && numel (strfind (said, "warning: gsmbp_")) == 1);
  gsmbp_check ("what is told stays so", strcmp (warning ("query", "gsmbp:stiff").state, "on"));
  warning ("off", "gsmbp:stiff", "local");
  gsmbp_check ("or not at all", isempty (evalc ("gsmbp_workprecision (o{:});")));
end
