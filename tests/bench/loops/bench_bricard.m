## b = bench_bricard (m): ten seconds of Bricard's six-bar by every way; a struct array of
## bench_run's with way and rtol.

function b = bench_bricard (m)
  b = struct ([]);
  for way = bench_ways ()
    for rtol = [1e-8 1e-10]
      r = bench_run (m, m.initial, 0:0.1:10, ...
                     {"rtol", rtol, "loops", way{1}, "maxsteps", 200000}, 0.05, []);
      r.way = way{1};
      r.rtol = rtol;
      b = [b, r];
    end
  end
end
