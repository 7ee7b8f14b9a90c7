## r = bench_compare (c, m, x0, truth, tolerances): every way at every tolerance; a struct array of
## bench_run's with way and rtol.

function r = bench_compare (c, m, x0, truth, tolerances)
  r = struct ([]);
  for way = bench_ways ()
    for rtol = tolerances
      options = [c.options, {"rtol", rtol, "loops", way{1}, "maxsteps", 100000}];
      one = bench_run (m, x0, c.times, options, 0.05, truth);
      one.mechanism = c.name;
      one.way = way{1};
      one.rtol = rtol;
      r = [r, one];
    end
  end
end
