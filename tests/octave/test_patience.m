## Ctrl-C and "timeout": a run ends at once with the rows so far, bit for bit those of the
## whole run, and the session goes on; all methods, loops, samples, events, functions of the user,
## many runs.

function test_patience ()
  for id = {"stiff", "stopped", "energy"}
    warning ("off", ["gsmbp:" id{1}], "local");
  end
  axis = gsmbp_hand ("motor_pendulum");
  rand ("state", 5);
  by_time (axis);
  with_room (gsmbp_fixture ("sampled_drive"));
  late = by_signal (axis, "dp853", {"input", 1, "maxstep", 1e-3});
  late(end+1) = by_signal (axis, "rk4", {"input", 1, "method", "rk4"});
  late(end+1) = by_signal (axis, "radau", {"input", 1, "method", "radau", "maxstep", 1e-3});
  late(end+1) = by_signal (axis, "auto", {"input", 1, "method", "auto", "maxstep", 1e-3});
  late(end+1) = by_signal (gsmbp_fixture ("gauss_arms"), "gauss, by momenta", {"method", "gauss"});
  late(end+1) = by_signal (gsmbp_fixture ("case_02a_motor"), "loops", {"maxstep", 1e-3});
  late(end+1) = by_signal (gsmbp_fixture ("sampled_drive"), "samples", {"maxstep", 1e-3});
  late(end+1) = by_signal (gsmbp_fixture ("event_ball"), "events", {"maxstep", 1e-3});
  late(end+1) = by_signal (axis, "a function of the user", {"input", @(t, x) 1});
  gsmbp_check ("within 0.1 s", min (late) < 0.1 && median (late) < 0.2);
  many (axis);
  many_at_once (axis);
  if (! isempty (getenv ("GSMBP_WHOLE")))   # it builds in quad precision
    inside (axis);
    reference (axis);
  end
  if (gsmbp_has_sundials ())
    by_signal (axis, "cvode", {"input", 1, "method", "cvode", "maxstep", 1e-3});
  end
end

function by_time (m)
  t = 0:0.01:50;
  w = gsmbp_simulate (m, m.initial, t, "input", 1, "maxstep", 1e-4);
  gsmbp_check ("a whole run was not stopped", strcmp (w.stats.stopped, ""));
  [r, info] = gsmbp_simulate (m, m.initial, t, "input", 1, "maxstep", 1e-4, "timeout", ...
                              w.stats.seconds / 3);
  n = numel (r.t);
  gsmbp_check ("timeout: INFO, the reason", info == 10 && strcmp (r.stats.stopped, "timeout"));
  gsmbp_check ("timeout: the rows so far are those of the whole run", ...
               n > 1 && n < numel (t) && isequal (r.x, w.x(1:n,:)) && isequal (r.v, w.v(1:n,:)));
  gsmbp_check ("timeout: the time that was reached", ...
               r.stats.reached >= r.t(end) && r.stats.reached < t(n+1) + 1e-12);
  lastwarn ("");
  warning ("on", "gsmbp:stopped", "local");
  gsmbp_simulate (m, m.initial, 0:1e5, "input", 1, "timeout", 0.1, "maxstep", 1e-3);
  gsmbp_check ("timeout: a warning tells", ...
               any (strfind (lastwarn (), "ended by option timeout")));
  gsmbp_check ("timeout: refused", ...
               any (strfind (gsmbp_complaint (@() gsmbp_simulate (m, m.initial, [0 1], ...
                                                                  "timeout", -1)), ...
                             "option timeout")));
end

## room for 6e7 records of samples, GBs of it, takes no time where a run does not come so far
function with_room (m)
  begun = cputime ();
  [r, info] = gsmbp_simulate (m, m.initial, [0 6e6], "timeout", 0.2, "maxstep", 1e-3);
  spent = cputime () - begun;
  gsmbp_check ("timeout: a run with room for many records", info == 10 && numel (r.t) == 1 ...
               && ! isempty (r.samples.t) && r.samples.t(end) <= r.stats.reached);
  gsmbp_check ("timeout: room that is not used takes no time", spent - 0.2, 1);
end

## SIGINT to this session at a seeded instant of a run that would last for hours; how late it ended
function late = by_signal (m, what, options)
  t = 0:0.05:5e4;
  w = gsmbp_simulate (m, m.initial, t, options{:}, "timeout", 0.2);
  file = tempname ();
  system (sprintf ("(sleep %g; date +%%s.%%N >%s; kill -INT %d) >/dev/null 2>&1 &", ...
                   0.3 + 0.2 * rand (), file, getpid ()));
  [r, info] = gsmbp_simulate (m, m.initial, t, options{:});
  late = time () - str2double (fileread (file));
  unlink (file);
  gsmbp_check ([what ": Ctrl-C ends it"], info == 9 && strcmp (r.stats.stopped, "interrupted"));
  n = min (numel (r.t), numel (w.t));
  gsmbp_check ([what ": the rows so far are those of another run"], ...
               n > 1 && isequal (r.x(1:n,:), w.x(1:n,:)) && isequal (r.v(1:n,:), w.v(1:n,:)) ...
                 && isequaln (r.y(1:n,:), w.y(1:n,:)));
end

function many (m)
  t = [0 5 10];
  table = struct ("m", linspace (1, 2, 2000));
  o = {"input", 1, "maxstep", 1e-4, "parameters", table, "threads", 2};
  e = gsmbp_ensemble (m, m.initial, t, o{:}, "timeout", 0.6);
  k = find (e.ok);
  gsmbp_check ("many runs: some ended, the others say why", ...
               strcmp (e.stopped, "timeout") && numel (k) > 1 && ! e.ok(end) ...
                 && any (strfind (e.reason{end}, "not begun: ended by option timeout")));
  f = gsmbp_ensemble (m, m.initial, t, "input", 1, "maxstep", 1e-4, "parameters", ...
                      struct ("m", table.m(k)));
  gsmbp_check ("many runs: those that ended are the same", isequal (e.x(:,:,k), f.x));
end

## a reference that does not come to its end measures nothing
function reference (m)
  said = gsmbp_complaint (@() gsmbp_workprecision (m, m.initial, [0 1e7], "input", 1, "dp853", ...
                                                   1e-6, "rk4", [], "timeout", 0.2));
  gsmbp_check (["no reference, no measurement: " said], ...
               ! isempty (strfind (said, "the reference, in quad precision, ended at t = ")));
end

## a sweep keeps the chunks that were finished
function many_at_once (m)
  system (sprintf ("(sleep 1.5; kill -INT %d) >/dev/null 2>&1 &", getpid ()));
  w = gsmbp_sweep (m, m.initial, 0:0.01:5, "input", 1, "vary", struct ("m", [1 2]), "runs", 2e5, ...
                   "keep", {"final q"});
  gsmbp_check ("a sweep: Ctrl-C ends it, finished runs stay", ...
               strcmp (w.stopped, "interrupted") && any (w.ok) && ! all (w.ok) ...
                 && all (isfinite (w.values(w.ok,2))));
end

## under another function of the package Ctrl-C ends that: half a run is no part of its result
function inside (m)
  script = [tempname() ".m"];
  lines = {["addpath (\"" fileparts(which ("gsmbp_build")) "\", \"" ...
            fileparts(which ("gsmbp_hand")) "\");"], ...
           "m = gsmbp_hand (\"motor_pendulum\");", ...
           "gsmbp_workprecision (m, m.initial, [0 0.1], \"input\", 1);", ... # all is compiled
           "system (sprintf (\"(sleep 1.5; kill -INT %d) >/dev/null 2>&1 &\", getpid ()));", ...
           "w = gsmbp_workprecision (m, m.initial, [0 1e6], \"input\", 1);", ...
           "printf (\"went on\\n\");"};
  fid = fopen (script, "w");
  fprintf (fid, "%s\n", lines{:});
  fclose (fid);
  [code, text] = system (sprintf ("timeout 180 octave-cli -qf '%s' 2>&1", script));
  unlink (script);
  gsmbp_check ("a function that needs whole runs ends with them", ...
               code == 1 && isempty (strfind (text, "went on")) ...
                 && isempty (strfind (text, "error")));
end
