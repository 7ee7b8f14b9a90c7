## loops.m: the bench of the loops, called by `make bench-loops`. Writes loops.md and loops.json
## beside itself, figures into out/.
##
## Every mechanism of loops/bench_cases.m that has a scene, every way to integrate its loops, five
## tolerances: time, error against quad precision, drift, energy. Then Andrews' squeezer against
## SUNDIALS IDA, the ladder of four-bars through its singular positions, ten seconds of Bricard's
## six-bar. BENCH_LOOPS="andrews bricard" takes these mechanisms only; BENCH_LADDER="2 5" other
## ladders.

here = fileparts (mfilename ("fullpath"));
addpath (fullfile (fileparts (fileparts (here)), "octave"));
addpath (fullfile (here, "loops"));
out = fullfile (here, "out");
[~, ~] = mkdir (out);
warning ("off", "gsmbp:singular");
warning ("off", "gsmbp:angles");
tolerances = 10 .^ -(4:2:12);
wanted = strsplit (strtrim (getenv ("BENCH_LOOPS")));
ladders = str2num (getenv ("BENCH_LADDER"));
if (isempty (ladders))
  ladders = [5 10 20 40];
end

all = struct ([]);
truths = struct ([]);
skipped = {};
for c = bench_cases ()
  if (! isempty (wanted{1}) && ! any (strcmp (wanted, c.name)))
    continue;
  end
  printf ("%s ...\n", c.name);
  try
    m = bench_scene (c.name, out);
    if (isempty (m))
      puts ("no scene\n");
      continue;
    end
    x0 = bench_start (m, c);
    [truth, known, way] = bench_truth (c.name, out, x0, c.times, c.options);
    runs = bench_compare (c, m, x0, truth, tolerances);
  catch problem
    skipped{end+1} = sprintf ("%s: %s", c.name, strtok (problem.message, "\n"));
    continue;
  end
  truths = [truths, ...
            struct("name", c.name, "what", c.what, "span", c.times(end) - c.times(1), "known", ...
                   known, "way", way, "rows", m.sizes.nlam, "coordinates", m.sizes.nq)];
  all = [all, runs];
end
andrews = struct ("own", [], "ida", []);
bricard = ladder = [];
if (isempty (wanted{1}) || any (strcmp (wanted, "andrews")))
  puts ("Andrews against IDA ...\n");
  andrews = bench_andrews (bench_scene ("andrews", out), out);
end
if (isempty (wanted{1}) || any (strcmp (wanted, "bricard")))
  puts ("Bricard ...\n");
  bricard = bench_bricard (bench_scene ("bricard", out));
end
if (isempty (wanted{1}) || any (strncmp (wanted, "ladder", 6)))
  puts ("ladders ...\n");
  ladder = bench_ladder (out, ladders);
end
save ("-binary", fullfile (out, "loops.bin"), "truths", "all", "skipped", "andrews", "ladder", ...
      "bricard");
text = bench_text (truths, all, skipped, andrews, ladder, bricard, out);
bench_save (fullfile (here, "loops.md"), text);
bench_save (fullfile (here, "loops.json"), ...
            jsonencode (struct ("mechanisms", {truths}, "runs", {all}, "andrews", andrews, ...
                                "ladder", {ladder}, "bricard", {bricard})));
puts (text);
