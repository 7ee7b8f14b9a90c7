## Every example on the motion of its driver at the default tolerance: what the energy audit cannot
## find is below 1e-8 of the energy that passed.

function test_audits ()
  root = fullfile (fileparts (mfilename ("fullpath")), "..", "..");
  for name = {"stewart", "welding_arm", "scara"}
    addpath (fullfile (root, "examples", name{1}));
  end
  own = fullfile (getenv ("GSMBP_TEST_DIR"), "audits");
  ## in no other test
  others = {"hooke/hooke_double", "pneumatic_position/pneumatic_axis", ...
            "robot_joint/robot_joint_sampled"};
  for k = 1:numel (others)
    [status, text] = system (sprintf ("%s %s %s 2>&1", ...
                                      fullfile (root, "share", "make", "derive"), ...
                                      fullfile (root, "examples", [others{k} ".mac"]), own));
    gsmbp_check ([others{k} " derives"], status == 0);
    [~, others{k}] = fileparts (others{k});
  end
  drivers = glob (fullfile (root, "examples", "*", "run.m"))';
  [~, names] = cellfun (@(f) fileparts (fileparts (f)), drivers, "UniformOutput", false);
  status = system (["make --no-print-directory -C '" root "'" ...
                    sprintf(" fortran_out/%s.f", names{:}) " >/dev/null 2>&1"]);
  gsmbp_check ("all examples are derived", status == 0);
  names = [names, others];
  warning ("off", "gsmbp:stiff", "local");
  for name = names
    [m, x0, t, options, what] = example_motion (name{1}, @(n) build (n, others, own));
    r = gsmbp_simulate (m, x0, t, options{:});
    gsmbp_check (sprintf ("%s, %s: energy audit", name{1}, what), r.audit.error, 1e-8);
  end
  m = gsmbp_fixture ("flexible_drive");
  r = gsmbp_simulate (m, m.initial, [0, 1], "input", 2, "audit", 1, "start", "project");
  gsmbp_check ("a rotor on an elastic coupling about the axis of the crank: energy audit", ...
               r.audit.error, 1e-8);
  gsmbp_check ("... it swings against the crank", max (abs (r.of.d)) > 1e-4);
  r = gsmbp_simulate (gsmbp_fixture ("switch_circuit"), [0; 0], [0, 0.01], "audit", 1);
  gsmbp_check ("where there is no energy nothing is audited", isnan (r.audit.error));
end

function m = build (name, others, own)
  if (any (strcmp (name, others)))
    m = gsmbp_build (name, "directory", own);
  else
    m = example_model (name);
  end
end
