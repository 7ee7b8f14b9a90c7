## l = bench_ladder (out, sizes): ladders of four-bars through their singular positions for 10 s,
## started upright with 1 m/s at the tips; energy at every 0.1 s. A struct array of bench_run's with
## loops (their number), way, rtol, total [J] (energy at the start, heights from the ground), loss
## (largest change beside that), passed (times that all rods lay in one line), apart (largest
## difference of two cranks at the end [rad]), rhs, prj (seconds of one call).

function l = bench_ladder (out, sizes)
  l = struct ([]);
  for n = sizes
    name = sprintf ("ladder%d", n);
    c = struct ("speeds", {{"q", -1, "p", 1}}, "hold", {{}});
    m = bench_scene (name, out);
    x0 = bench_start (m, c);
    ## at the start some pivots vanish by symmetry
    later = gsmbp_simulate (m, x0, [0 0.2]).x(end,:)';
    time = gsmbp_timing (m, 0.2, later, "print", false);
    for way = {"projection", "partitioning"}
      for rtol = [1e-6 1e-8 1e-10]
        options = {"rtol", rtol, "loops", way{1}, "maxsteps", 3000};
        r = bench_run (m, x0, 0:0.1:10, options, 0, []);
        r.loops = n;
        r.way = way{1};
        r.rtol = rtol;
        e = m.ene (0, x0);
        r.total = sum (e(1:3));
        r.loss = r.energy * r.exchanged / r.total;
        r.rhs = time.rhs;
        r.prj = time.prj;
        crank = NaN;
        if (! isempty (r.last))
          crank = abs (r.last(strncmp (m.coordinates, "q", 1)));
        end
        r.passed = floor (crank(1) / pi + 0.5);
        r.apart = range (crank);
        l = [l, r];
      end
    end
  end
end
