## Margins of devices (strokes, pressures) in many runs: as gsmbp_simulate looks at them in one, in
## ensembles, sweeps and the programs of sweeps; starts where a device cannot be.

function test_many_margins ()
  m = gsmbp_fixture ("trim_hydraulic");
  runs (m);
  swept (m);
  starts (m);
end

function o = options ()
  o = {"input", 0, "rtol", 1e-8, "atol", 1e-6};
end

## least values over the times by M.mar, and what stats.margins of each run has
function runs (m)
  fl = linspace (-20000, 60000, 6);
  t = 0:0.002:0.1;
  warning ("off", "gsmbp:margin", "local");
  for i = 1:6
    one = gsmbp_set (m, "fl", fl(i));
    r = gsmbp_simulate (one, m.initial, t, options (){:});
    for k = 1:numel (t)
      g(:,k) = one.mar (t(k), r.x(k,:)', r.v(k,:)');
    end
    least(i,:) = min (g, [], 2)';
    passed(i,:) = ismember (m.state_margins, {r.stats.margins.text})';
  end
  lastwarn ("", "");
  warning ("on", "gsmbp:margin", "local");
  e = gsmbp_ensemble (m, m.initial, t, options (){:}, "parameters", struct ("fl", fl));
  [said, id] = lastwarn ();
  gsmbp_check ("least values of the margins", e.margins - least, 0);
  gsmbp_check ("those that are passed", any (passed(:)) && isequal (e.outside, passed));
  wanted = sprintf ("outside of their margins in %d of 6 runs; run 1, at t = ", ...
                    nnz (any (passed, 2)));
  gsmbp_check (["one warning: " said], strcmp (id, "gsmbp:margin") && any (strfind (said, wanted)));
  lastwarn ("", "");
  e = gsmbp_ensemble (m, m.initial, t, options (){:}, "parameters", struct ("fl", [0, 1e4]));
  gsmbp_check ("none where all is well", isempty (lastwarn ()) && ! any (e.outside(:)));
end

## a sweep keeps them, demands them, warns once; its program keeps the same
function swept (m)
  folder = tempname ();
  tidy = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
  back = without_mpi ();
  fl = linspace (-20000, 60000, 6);
  t = 0:0.002:0.1;
  o = [{m.initial, t}, options(), {"vary", struct("fl", fl), "plan", "grid", "keep", ...
       {"state_margin1", "final x", "state_margin2"}, "demand", {"state_margin2", 0, Inf}}];
  lastwarn ("", "");
  warning ("on", "gsmbp:margin", "local");
  w = gsmbp_sweep (m, o{:}, "chunk", 4);
  [said, id] = lastwarn ();
  warning ("off", "gsmbp:margin", "local");
  e = gsmbp_ensemble (m, m.initial, t, options (){:}, "parameters", struct ("fl", fl));
  gsmbp_check ("a sweep keeps the least values", w.values(:,[2, 4]) - e.margins(:,1:2), 0);
  gsmbp_check ("... and counts those that keep one", ...
               w.yield - mean (e.margins(:,2) >= 0), 0);
  gsmbp_check (["one warning: " said], strcmp (id, "gsmbp:margin") && ! isempty (strfind ...
                 (said, sprintf ("in %d of 6 runs, run 1 first", nnz (any (e.outside, 2))))));
  p = gsmbp_sweep (m, o{:}, "program", folder);
  file = fullfile (folder, "sweep.h5");
  system (sprintf ("cd / && %s -o %s >/dev/null 2>&1", p.program, file));
  gsmbp_check ("its program keeps the same", isequal (load ("-hdf5", file).table', w.values));
  said = gsmbp_complaint (@() gsmbp_sweep (m, o{1:end-4}, "keep", {"state_margin7"}));
  gsmbp_check (["there is no such margin: " said], ...
               any (strfind (said, "expected the number of a margin (m.state_margins), 1 to 6")));
end

## a piston that starts out of its stroke, by its place or by its length
function starts (m)
  x = [m.initial, m.initial, m.initial];
  x(1,2) = 1.5;
  e = gsmbp_ensemble (m, m.initial, [0 0.01], options (){:}, "starts", x');
  said = gsmbp_complaint (@() gsmbp_simulate (m, x(:,2), [0 0.01], options (){:}));
  gsmbp_check (["a start out of the stroke fails alone: " e.reason{2}], ...
               isequal (e.ok', [true, false, true]) && ! isempty (e.reason{2}) ...
               && ! isempty (strfind (said, e.reason{2})));
  e = gsmbp_ensemble (m, m.initial, [0 0.01], options (){:}, "parameters", ...
                      struct ("C_h", [m.par.C_h, 0.2]));
  gsmbp_check (["a stroke too short: " e.reason{2}], isequal (e.ok', [true, false]) ...
               && any (strfind (e.reason{2}, "a device cannot be there: C: piston within")));
  warning ("off", "gsmbp:margin", "local");
  e = gsmbp_ensemble (m, m.initial, [0 0.01], options (){:}, "starts", x', "start", "project");
  gsmbp_check ("... but as it is where that is wanted", all (e.ok) && e.outside(2,6));
end
