## Ctrl-C and "timeout" in gsmbp_collocate, gsmbp_optimize, gsmbp_adjoint: they end at once, the
## best so far is given back, the session goes on.  SIGTERM in a run ends Octave as usual.

function test_patience_design ()
  said = warning ();
  loud = onCleanup (@() warning (said));   # "all" with "local" leaves them on
  warning ("off", "all");
  rand ("state", 7);
  collocation (gsmbp_fixture ("optimal_cart"));
  design (gsmbp_hand ("motor_pendulum"));
  backward (gsmbp_fixture ("sensitivity_crank"));
  ended_with_octave ();
end

## SIGINT to this session at an instant of a call of F that would last for longer; how late it ended
function [late, r, said] = interrupted (f, from)
  file = tempname ();
  system (sprintf ("(sleep %g; date +%%s.%%N >%s; kill -INT %d) >/dev/null 2>&1 &", ...
                   from + 0.3 * rand (), file, getpid ()));
  r = [];
  said = "";
  try
    r = f ();
  catch err
    said = err.message;
  end
  late = time () - str2double (fileread (file));
  unlink (file);
end

function collocation (m)
  solve = @(varargin) gsmbp_collocate (m, zeros (4, 1), [1 pi 0 0], "goal", "effort", "time", 2, ...
                                       varargin{:});
  fine = {"accuracy", 1e-13, "refinements", 20};
  first = solve ("refinements", 0);   # it builds Ipopt's module, too
  r = solve (fine{:}, "timeout", 1);
  gsmbp_check (["collocation: timeout: " r.ended], strcmp (r.stopped, "timeout") && ! r.solved ...
                 && ! isempty (strfind (r.ended, "ended by option timeout; solved on")) ...
                 && abs (r.goal - first.goal) < 1e-2 * first.goal);
  late = [];
  for from = [0.2, 0.5, 2]   # the last one in an iteration that takes seconds
    solve ("refinements", 0);   # waits for what an ended one has left behind
    [late(end+1), r] = interrupted (@() solve (fine{:}), from);
    gsmbp_check (["collocation: Ctrl-C: " r.ended], strcmp (r.stopped, "interrupted") ...
                   && abs (r.goal - first.goal) < 1e-2 * first.goal);
  end
  gsmbp_check (sprintf ("collocation: it ends within 0.1 s, found %.3f", min (late)), ...
               min (late) < 0.1 && max (late) < 0.5);
  r = solve ("refinements", 0);
  gsmbp_check ("collocation: the session is as it was", isequal (r.x, first.x));
end

function design (m)
  free = {"m", 1, [0.5 2]; "l", 0.5, [0.3 0.8]};
  load_case = {"run", 0:0.01:2, [0.1 0 0], "maxstep", 2e-4, "input", 1};
  solve = @(varargin) gsmbp_optimize (m, free, {"peak", "q"}, {}, load_case, varargin{:});
  gsmbp_optimize (m, free(1,:), {"mean", "q"}, {}, {"run", [0 0.1], [0.1 0 0], "input", 1}, ...
                  "solver", "ipopt", "iterations", 1);   # it builds
  [r, info] = solve ("timeout", 3, "starts", 30);
  gsmbp_check ("a design: timeout: the best so far", info == 1 && strcmp (r.stopped, "timeout") ...
                 && r.limit && isfinite (r.J) && r.J <= 0.2562);
  late = [];
  for solver = {"slsqp", "cobyla", "ipopt"}
    if (strcmp (solver{1}, "ipopt") || gsmbp_has_nlopt ())
      [late(end+1), r, said] = interrupted (@() solve ("solver", solver{1}, "starts", 30), 2);
      gsmbp_check (["a design by " solver{1} ": Ctrl-C: the best so far" said], isstruct (r) ...
                   && strcmp (r.stopped, "interrupted") && isfinite (r.J) && r.J <= 0.2562 ...
                     && strcmp (r.ended, "interrupted by Ctrl-C"));
    end
  end
  gsmbp_check (sprintf ("a design: it ends within 0.1 s, found %.3f", min (late)), ...
               min (late) < 0.1 && max (late) < 0.5);
end

function backward (m)
  x = gsmbp_assemble (m, m.initial);
  goal = @(r) deal (r.x(end,1), [zeros(rows (r.x) - 1, m.sizes.nx); 1, zeros(1, m.sizes.nx - 1)]);
  run = @(varargin) gsmbp_adjoint (m, x, [0 20000], goal, "input", zeros (1, m.sizes.nv), ...
                                   varargin{:});
  [late, ~, said] = interrupted (@() run (), 0.3);
  gsmbp_check (["an adjoint: Ctrl-C: " said], late < 0.5 ...
                 && ! isempty (strfind (said, "interrupted by Ctrl-C on the way forward at t = ")));
  said = gsmbp_complaint (@() run ("timeout", 0.2));
  gsmbp_check (["an adjoint: " said], ! isempty (strfind (said, "ended by option timeout on the")));
end

## in a session of its own
function ended_with_octave ()
  folder = tempname ();
  mkdir (folder);
  tidy = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
  here = fileparts (which ("gsmbp_build"));
  script = fullfile (folder, "run.m");
  f = fopen (script, "w");
  fprintf (f, ["addpath (\"%s\", \"%s\"); m = gsmbp_hand (\"motor_pendulum\");\n" ...
               "tidy = onCleanup (@() disp (\"tidy\"));\n" ...
               "system (sprintf (\"(sleep 1; kill %%d) >/dev/null 2>&1 &\", getpid ()));\n" ...
               "gsmbp_simulate (m, m.initial, 0:1e5, \"input\", 1, \"maxstep\", 1e-3);\n" ...
               "disp (\"it went on\");\n"], here, fullfile (here, "hand"));
  fclose (f);
  [code, said] = system (sprintf ("cd %s && timeout 30 octave-cli -qf run.m 2>&1", folder));
  gsmbp_check ("SIGTERM in a run ends Octave as usual", code == 1 ...
                 && ! isempty (strfind (said, "tidy")) && isempty (strfind (said, "it went on")));
end
