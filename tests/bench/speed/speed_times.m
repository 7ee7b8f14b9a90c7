## times = speed_times (s, jobs): struct array with who, mode, word, ns (all rounds), median, low,
## high (10 % and 90 %) of one call; the quad build is left out, a yardstick (who = "yardstick": as
## many sines and cosines as the job of GSMBP has) joins.

function times = speed_times (s, jobs)
  jobs = jobs(! strcmp ({jobs.mode}, "quad"));
  for one = {"id", "inv"; "fd", "fwd"}'
    pairs = s.operations.lit.(one{2})(5) / 2;
    jobs(end+1) = speed_job ("yardstick", "lit", one{1}, "-", "-", "sincos", ceil (pairs));
  end
  ns = speed_run (s, speed_states (s, "random", 256), jobs, "time", 42);
  times = ...
      struct ("who", {jobs.who}, "mode", {jobs.mode}, "word", {jobs.word}, "ns", num2cell (ns, ...
      2)', "median", num2cell (median (ns, 2))',
    "low", num2cell (quantile (ns, 0.1, 2))', "high", num2cell (quantile (ns, 0.9, 2))');
end
