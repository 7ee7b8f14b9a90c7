## a = bench_andrews (m, out): Andrews' squeezer at t = 0.03 s against the 27 digits of the
## reference, by the ways of GSMBP and by SUNDIALS IDA.
##
## a.own, a.ida: struct arrays with way, rtol, seconds (of processor, the whole run), error
## (largest, of the seven angles), calls, steps; a.ida is empty without SUNDIALS.

function a = bench_andrews (m, out)
  root = fileparts (fileparts (fileparts (fileparts (mfilename ("fullpath")))));
  table = dlmread (fullfile (root, "tests", "data", "04_andrews_squeezer", "reference.csv"), ...
                   ",", 1, 0);
  truth = table(end,2:8);
  a.end = table(end,1);
  x0 = m.initial;
  a.own = struct ([]);
  for way = bench_ways ()
    for rtol = 10 .^ -(9:0.5:11)
      options = {"rtol", rtol, "atol", rtol * [ones(7, 1); 1e3 * ones(7, 1)], "loops", way{1}, ...
                 "drift", false};
      r = bench_run (m, x0, [0 a.end], options, 0.05, [x0(1:7)'; truth]);
      a.own = [a.own, ...
               struct("way", way{1}, "rtol", rtol, "seconds", r.seconds * a.end, "error", ...
                      r.error, "calls", r.calls, "steps", r.steps)];
    end
  end
  a.ida = struct ([]);
  program = bench_ida (m, out);
  if (isempty (program))
    return;
  end
  for form = {"ode", "index1s", "index2s", "ggls"}
    for rtol = 10 .^ -(11:0.5:13)
      [status, text] = system (sprintf ("'%s' %s %g %g 20 %s 2>/dev/null", program, form{1}, ...
                                 rtol, a.end, sprintf ("%.17g ", x0(1:14))));
      if (status == 2 || status > 100)
        error ("bench: andrews_ida failed");
      end
      v = [sscanf(text, "%f")', NaN(1, 20)];
      a.ida = [a.ida, ...
               struct("way", form{1}, "rtol", rtol, "seconds", v(1), "error", ...
                      max (abs (v(7:13) - truth)), "calls", v(3), "steps", v(2))];
    end
  end
end
