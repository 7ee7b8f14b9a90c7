## More events in a run than its record has: what ensembles and sweeps count and when, against
## closed forms, one by one, in lanes and in the program of a sweep; what ended a run.

function test_counted ()
  thermostat (gsmbp_fixture ("user_thermostat"));
  ended (gsmbp_fixture ("user_bounce"));
end

## x' falls from 1.5 to LOW, is driven from there to 2, and so on
function thermostat (m)
  T = 3600;
  low = [1, 1.01, 1.3, 1.02];
  fall = log (2 ./ low);
  rise = log (3 - low);
  from = [log(1.5 ./ low); log(1.5 ./ low) + rise];   # the first that is cold, hot
  period = fall + rise;
  known = floor ((T - from) ./ period) + 1;
  last = from + (known - 1) .* period;
  rows = @(part, k) part(:,strcmp ({m.events.name}, k));
  for lanes = [false, true]
    lastwarn ("", "");
    e = gsmbp_ensemble (m, [0 1.5], [0 T], "input", 0, "parameters", struct ("low", low), ...
                        "lanes", lanes);
    [said, id] = lastwarn ();
    what = {"one by one", "in lanes"}{1 + lanes};
    gsmbp_check ([what ": runs"], e.lanes == lanes);
    gsmbp_check ([what ": as many"], [rows(e.counted.count, "cold"), ...
                                    rows(e.counted.count, "hot")]' - known, 0);
    gsmbp_check ([what ": when the first was"], [rows(e.counted.first, "cold"), ...
                                               rows(e.counted.first, "hot")]' - from, 1e-7);
    gsmbp_check ([what ": when the last was"], [rows(e.counted.last, "cold"), ...
                                              rows(e.counted.last, "hot")]' - last, 1e-7);
    number = sum (e.counted.count, 2);
    gsmbp_check ([what ": the list has the first 10000"], ...
                 accumarray (e.events.run, 1) - min (number, 10000), 0);
    [most, k] = max (number);
    wanted = sprintf ("%d of 4 runs had more events than are listed of a run (run %d has %d", ...
                      nnz (number > 10000), k, most);
    gsmbp_check ([what ": a warning: " said], strcmp (id, "gsmbp:events") ...
                 && any (strfind (said, wanted)));
  end
  swept (m, T, low, known(1,:), from(1,:), last(1,:));
  lastwarn ("", "");
  e = gsmbp_ensemble (m, [0 1.5], [0 0.1], "input", 0, "parameters", struct ("low", low));
  gsmbp_check ("no event, no warning", isempty (lastwarn ()) && ! any (e.counted.count(:)) ...
               && all (isnan ([e.counted.first(:); e.counted.last(:)])));
end

## what a sweep keeps needs no record, nor a warning; in its program neither
function swept (m, T, low, known, from, last)
  folder = tempname ();
  tidy = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
  back = without_mpi ();
  o = {[0 1.5], [0 T], "input", 0, "plan", "grid", "vary", struct("low", low), "keep", ...
       {"count cold", "first cold", "last cold", "count middle"}};
  lastwarn ("", "");
  w = gsmbp_sweep (m, o{:});
  gsmbp_check ("a sweep keeps the count of all", w.values(:,2) - known', 0);
  gsmbp_check ("... the first and the last of all", [w.values(:,3) - from', ...
                                                         w.values(:,4) - last'], 1e-7);
  gsmbp_check ("... of an event both ways the sum", abs (w.values(:,5) - 2 * known') <= 1);
  gsmbp_check (["... without a warning " lastwarn()], isempty (lastwarn ()));
  p = gsmbp_sweep (m, o{:}, "program", folder);
  file = fullfile (folder, "sweep.h5");
  [code, said] = system (sprintf ("cd / && %s -o %s 2>&1", p.program, file));
  gsmbp_check (["its program ends well: " strtrim(strrep (said, folder, ""))], code == 0);
  gsmbp_check ("... with the same table, bit for bit", ...
               isequal (load ("-hdf5", file).table', w.values));
end

## what ended a run is known, though there was no place for it in the record
function ended (m)
  m = gsmbp_set (m, "e", 1, "last", 4600);
  warning ("off", "gsmbp:events", "local");
  r = gsmbp_simulate (m, [1 0], [0 5000], "rtol", 1e-8);
  gsmbp_check (sprintf ("ended by its event after %d of them: %s", r.stats.events, ...
                        r.stats.stopped), r.stats.events > 10000 ...
               && strcmp (r.stats.stopped, "event done") && abs (r.t(end) - 4600) < 1e-9);
end
