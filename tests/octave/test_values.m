## What a scene refuses gsmbp_set refuses, with the element in the message; a signal has one name
## with a dot or an underscore.

function test_values ()
  m = gsmbp_fixture ("value_rules");
  head = fileread (fullfile (m.directory, [m.name ".f"]))(1:200);
  gsmbp_check ("values: the model tells the version that the head of the Fortran tells", ...
               ! isempty (m.gsmbp_version) ...
               && ! isempty (strfind (head, ["emitted by GSMBP " m.gsmbp_version "."])));
  gsmbp_check ("values: and the hash of the scene", numel (m.scene_hash) == 16 ...
               && ! isempty (strfind (head, ["Hash of the scene: " m.scene_hash "."])));
  bad = {{"mc", -1}, "link a: mass must not be negative; found: mc = -1"
         {"mc", 1}, "link b: mass must not be negative; found: mc = 1"
         {"j1", -1}, "link a: inertia must have no negative eigenvalue"
         {"j1", 3}, "link a: inertia must have no negative eigenvalue"
         {"r", -1}, "link a: centre must be real and finite; found: r = -1"
         {"n", 0}, "revolute K: axis must not be the zero vector; found: n = 0"
         {"p", 0}, "spring S: rest must be real and finite; found: p = 0"
         {"al", 1}, "revolute K: rotation must be a rotation"
         {"M_R", 0}, "dc_motor M: R must be above 0; found: M_R = 0"
         {"M_J", -1}, "dc_motor M: J must not be negative"
         {"mc", NaN}, "parameter mc must be one finite number"
         {"mc", -Inf}, "parameter mc must be one finite number"
         {"mc", 1i}, "parameter mc must be one finite number"
         {"mc", []}, "parameter mc must be one finite number"};
  for i = 1:rows (bad)
    found = gsmbp_complaint (@() gsmbp_set (m, bad{i,1}{:}));
    gsmbp_check (sprintf ("values: %s", bad{i,2}), strfind (found, [m.name ": " bad{i,2}]) == 12);
  endfor
  found = gsmbp_complaint (@() gsmbp_build (m.name, "directory", m.directory, ...
                                            "parameters", struct ("mc", -1)));
  gsmbp_check ("values: gsmbp_build refuses them, too", ...
               ! isempty (strfind (found, "mass must not be negative")));
  good = gsmbp_set (m, "mc", 3, "j1", 0.8, "al", 0.3, "be", 0.3, "M_J", 0, "n", -2);
  gsmbp_check ("values: what the scene would take is taken", good.par.mc == 3 && good.par.n == -2);
  lastwarn ("", "");
  gsmbp_set (m, "k", -1);
  [text, id] = lastwarn ();
  gsmbp_check ("values: a negative stiffness is a warning", ...
               strcmp (id, "gsmbp:negative") ...
                 && ! isempty (strfind (text, "spring S: stiffness")));
  rail = gsmbp_fixture ("event_slide");
  found = gsmbp_complaint (@() gsmbp_set (rail, "fs", 0.9));
  gsmbp_check (["values: an inequality between parameters: " found], ...
               ! isempty (strfind (found, "friction F: expected Fs >= Fc; found: ")));
  gsmbp_check ("values: up to equality", gsmbp_set (rail, "fs", 1, "fc", 1).par.fs == 1);
  dots = gsmbp_complaint (@() gsmbp_trim (m, m.initial, 0, "hold", {"M.i"}, "free", {"no"}));
  lines = gsmbp_complaint (@() gsmbp_trim (m, m.initial, 0, "hold", {"M_i"}, "free", {"no"}));
  gsmbp_check ("values: M_i is M.i", ...
               strcmp (dots, lines) ...
               && ! isempty (strfind (dots, "expected the name of an input, found \"no\"")));
endfunction
