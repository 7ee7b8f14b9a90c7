## text = speed_report (results, peers, with_peers): the report in markdown.

function text = speed_report (results, peers, with_peers)
  text = ...
      ["# Benchmark\n\nWritten by `make bench`. Times are of one processor, one pinned " ...
       "thread, median of 42 rounds in which all jobs take turns [10 %, 90 %]; ratios are " ...
       "medians of\n" ...
    "the ratios within a round. Compare ratios, not times of other machines. All code that is " ...
    "compiled here has -O3 -march=native. ID inverse dynamics, M mass\nmatrix, FD forward " ...
    "dynamics, LIN the matrices M, B, C of the linear model; " ...
    "lit: parameters at run time, num: their numbers compiled in.\n", versions(peers, with_peers)];
  text = ...
      [text, summary(results), against_best(results), counts(results), times(results), ...
       rivals(results), jacobians(results), batches(results), speed_shares(results), ...
          errors(results), ...
          growth(results), passes(results)];
  text = [text, ...
          ["\n![time of a call against the number of links](out/speed/growth.png)\n\n![speed " ...
           "against error](out/speed/error.png)\n"]];
end

function text = versions (peers, with_peers)
  text = "";
  if (with_peers)
    text = ["\nRivals from PyPI: ", strjoin(strsplit (strtrim (fileread (fullfile (peers, ...
                "versions"))), "\n"), ", "), ...
      [". CasADi: Pinocchio's algorithms with CasADi's symbols, its cse and C code; SymPy: " ...
       "KanesMethod, cse, LDL';\nPinocchio: its C++ headers compiled here, the fastest of its " ...
       "three ways for FD; MuJoCo: its shared library, kernels that the result needs alone.\n"]];
  end
end

## operations as one number: mul + add + div
function k = total (o)
  k = sum (o(1:3));
end

function t = spread (one)
  t = "-";
  if (! isempty (one))
    t = sprintf ("%.4g [%.4g, %.4g]", one(1).median, one(1).low, one(1).high);
  end
end

function t = number (format, x)
  t = "-";
  if (isfinite (x))
    t = sprintf (format, x);
  end
end

## ---------------------------------------------------------------------------------------- sections

function text = summary (results)
  rows = {};
  for s = results
    d = @(r) seconds (s, r);
    m = s.modes{end};
    o = s.operations.lit;
    e = speed_pick (s.errors, "gsmbp", "lit", "id")(1);
    f = speed_pick (s.errors, "gsmbp", "lit", "fd")(1);
    row = {s.name, sprintf("%d", s.n), number("%.2f", d("M+bias")), number("%.2f", ...
        d("all")), number("%.2f", d("LIN")), compilation(s, "lit"), ...
      strjoin(cellfun (@(w) number ("%d", total (o.(w))), {"inv", "mas", "fwd", "lin"}, ...
                       "UniformOutput", false), " / "), ...
      ns(s, "id"), ns(s, "mm"), ns(s, "fd"), ns(s, "lin"), sprintf("%.1e, %.1e", e.median, ...
          e.worst), sprintf("%.1e, %.1e", f.median, f.worst)};
    rows{end+1} = row;
  end
  text = ...
      speed_table ("Summary", ["Derivation: processor seconds of Maxima with the scene's " ...
                               "reading, without Maxima's start, for M and bias (what the " ...
                               "rivals' figures are for), for\n" ...
    "ID, M, bias and FD, for LIN; compilation of ID, M, bias and FD + LIN (compiled and timed " ...
    "up to 16 links). Operations: mul + add + div of ID / M / FD / LIN, lit. Times in ns, lit " ...
    "/ num. Errors: median, worst of random states."],
    {"system", "n", "M+bias s", "all s", "LIN s", "compile s", "operations", "ID ns", "M ns", ...
     "FD ns", "LIN ns", "error ID", "error FD"}, rows);
end

function t = ns (s, word)
  t = strjoin (cellfun (@(m) number ("%.4g", first_of (speed_pick (s.times, "gsmbp", m, word))), ...
                        s.modes, "UniformOutput", false), " / ");
end

## the median of what was picked; NaN where there is none
function t = first_of (picked)
  t = NaN;
  if (! isempty (picked))
    t = picked(1).median;
  end
end

## seconds of derivation of a part, lit; NaN where it was left out
function t = seconds (s, part)
  t = [s.derive(strcmp ({s.derive.mode}, "lit") & strcmp ({s.derive.requests}, part)).cpu, NaN](1);
end

function t = compilation (s, mode)
  t = sprintf ("%.2f", s.compile.(mode));
  if (isfield (s.compile, [mode "_lin"]))
    t = sprintf ("%s + %.2f", t, s.compile.([mode "_lin"]));
  end
end

## the least totals published or measured of any generator (OpenSYMORO's base parameters,
## SymPyBotics, CasADi), parameters literal
function text = against_best (results)
  best = struct ("puma3", [187 67 348], "puma6", [380 316 1065], "spat6", [616 566 1955], ...
                 "spat16", [2251 3375 6341], "spat32", [4683 11999 13409], "pend32", ...
                 [1024 4608 3116]);
  required = struct ("puma3", [.60 .45 .43], "puma6", [.87 .60 .59], "spat6", [.90 .58 .53], ...
                     "spat16", [.80 .76 .72], "spat32", [.80 .76 .72], "pend32", [.95 .95 .95]);
  rows = {};
  for s = results
    if (! isfield (best, s.name))
      continue;
    end
    row = {s.name};
    for k = 1:3
      c = cellfun (@(m) total (s.operations.(m).({"inv", "mas", "fwd"}{k})), s.modes);
      row = [row, {sprintf("%d", best.(s.name)(k)), strjoin(arrayfun (@num2str, c, ...
            "UniformOutput", false), " / "), ...
        sprintf("%.2f %s %.2f", c(1) / best.(s.name)(k), ...
                {"<=", "**>**"}{1 + (c(1) > required.(s.name)(k) * best.(s.name)(k))}, ...
                required.(s.name)(k))}];
    end
    o = s.operations.lit;
    rows{end+1} = [row, {number("%.2f", total (o.lin) / total (o.inv))}];
  end
  text = ...
      speed_table ("Operations against the best rival", ...
                   ["The rivals' totals are a table: OpenSYMORO with base parameters (ID, M " ...
                    "of arms), SymPyBotics (FD of arms), CasADi (FD of longer chains). Ours " ...
                    "lit / num; the\n" ...
    "ratio is lit's, beside the one required."], {"system", "ID best", "ID", "ratio", "M best", ...
        "M", "ratio", "FD best", "FD", "ratio", "LIN : ID"}, rows);
end

function text = counts (results)
  rows = {};
  for s = results
    for m = s.modes
      o = s.operations.(m{1});
      row = {s.name, m{1}};
      for w = {"inv", "mas", "fwd", "lin"}
        row{end+1} = strrep (sprintf ("%d/%d/%d/%d/%d", o.(w{1})), "NaN/NaN/NaN/NaN/NaN", "-");
      end
      rows{end+1} = row;
    end
  end
  text = speed_table ("Operations by kind", ...
                      ["mul/add/div/sqrt/trig of the executed Fortran; X**2 is one mul, unary " ...
                       "minus free."], {"system", "mode", "ID", "M", "FD", "LIN"}, rows);
end

function text = times (results)
  rows = {};
  for s = results
    for m = s.modes
      rows{end+1} = [{s.name, m{1}}, cellfun(@(w) spread (speed_pick (s.times, "gsmbp", m{1}, ...
              w)), {"id", "fd", "mm", "lin"}, "UniformOutput", false), ...
        cellfun(@(w) sprintf ("%.2f", ...
                              speed_ratio (s.times, {"gsmbp", m{1}}, {"yardstick", "lit"}, w)), ...
                {"id", "fd"}, "UniformOutput", false)];
    end
  end
  text = ...
      speed_table ("Time of one call", ["ns. The yardstick is a loop of as many sines and " ...
                                        "cosines as the routine holds: time over the yardstick's."],
    {"system", "mode", "ID", "FD", "M", "LIN", "ID : yardstick", "FD : yardstick"}, rows);
end

## the fastest of the rival's ways to a word
function r = fastest (s, ours, names, mode, word)
  r = min (cellfun (@(who) speed_ratio (s.times, {who, mode}, {"gsmbp", ours}, word), names));
end

function text = rivals (results)
  rows = derived = {};
  for s = results
    for m = s.modes
      row = {s.name, m{1}};
      for w = {"id", "fd", "mm"}
        row{end+1} = number ("%.2f", ...
                             speed_ratio (s.times, {"gsmbp", m{1}}, {"casadi", m{1}}, w{1}));
      end
      for w = {"id", "fd"}
        row = [row, {number("%.1f", ...
                            fastest (s, m{1}, ...
                                     {"pinocchio", "pinocchio_local", "pinocchio_mass"}, "num", ...
                                     w{1})), ...
          number("%.1f", ...
                 fastest (s, m{1}, {"mujoco_lean", "mujoco"}, "num", w{1})), number("%.2f", ...
              fastest (s, m{1}, {"sympy"}, m{1}, w{1}))}];
      end
      rows{end+1} = row;
      c = {};
      for who = {"casadi", "sympy"}
        o = arrayfun (@(k) speed_pick (s.made, who{1}, m{1}, k{1}), {"id", "mm", "fd"}, ...
                      "UniformOutput", false);
        if (! isempty (o{3}))
          c = [c, ...
               {cpu(o{3}.cpu), ...
                strjoin(cellfun (@(x) number ("%d", total (x.operations)), o, "UniformOutput", ...
                                 false), " / "), sprintf("%.2f", o{3}.compile)}];
        else
          c = [c, {"-", "-", "-"}];
        end
      end
      d = s.derive(strcmp ({s.derive.mode}, m{1}));
      o = s.operations.(m{1});
      derived{end+1} = [{s.name, m{1}, sprintf("%.2f", d(strcmp ({d.requests}, "FD")).cpu), ...
                         sprintf("%d / %d / %d", total (o.inv), total (o.mas), total (o.fwd))}, ...
                        c];
    end
  end
  text = "";
  if (any (arrayfun (@(s) ! isempty (s.made), results)))
    text = ...
        [speed_table("Time against the rivals", ["Ours over CasADi's in the same mode (below " ...
                                                 "1: ours is faster); how many times slower " ...
                                                 "Pinocchio, MuJoCo (both hold their numbers) " ...
                                                 "and SymPy (same mode) are."],
      {"system", "mode", "ID : CasADi", "FD : CasADi", "M : CasADi", "Pinocchio : ID", ...
       "MuJoCo : ID", "SymPy : ID", "Pinocchio : FD", "MuJoCo : FD", "SymPy : FD"}, rows), ...
      speed_table("Derivation and operations beside the rivals", ...
                  ["Derivation of FD: processor seconds from the model to the source text; " ...
                   "operations of ID / M / FD, mul + add + div; compilation of all three."],
      {"system", "mode", "derive s", "operations", "CasADi derive s", "operations", "compile s", ...
       "SymPy derive s", "operations", "compile s"}, derived)];
  end
end

function text = jacobians (results)
  lines = {};
  mean_of = [];
  for s = results
    for m = s.modes
      t = speed_pick (s.times, "gsmbp", m{1}, "jac");
      if (isempty (t))
        continue;
      end
      r = speed_ratio (s.times, {"gsmbp", m{1}}, {"casadi", m{1}}, "jac");
      if (strcmp (m{1}, "lit") && isfinite (r))
        mean_of(end+1) = r;
      end
      made = speed_pick (s.made, "casadi", m{1}, "jac");
      theirs = NaN;
      if (! isempty (made))
        theirs = total (made.operations);
      end
      e = speed_pick (s.errors, "gsmbp", m{1}, "jac");
      f = speed_pick (s.errors, "casadi", m{1}, "jac");
      lines{end+1} = {s.name, m{1}, spread(t), number("%.2f", ...
                      median (t.ns ./ speed_pick (s.times, "gsmbp", m{1}, "least")(1).ns)), ...
                      number("%.2f", r), number("%.2f", ...
                      speed_ratio (s.times, {"gsmbp", m{1}}, {"pinocchio", "num"}, "jac")), ...
                      sprintf("%d", total (s.operations.(m{1}).jac)), number("%d", theirs), ...
                      worst_words(e), worst_words(f)};
    end
  end
  if (! isempty (mean_of))
    lines{end+1} = {"geometric mean", "lit", "", "", number("%.2f", ...
                    exp (mean (log (mean_of)))), "", "", "", "", ""};
  end
  text = speed_table ("Jacobian of the state equations", ...
                      ["JAC without torques, ns; over the time of FD, LIN and their solution " ...
                       "by Cholesky's method,\ncalled one after the other; over CasADi's in " ...
                       "the same mode (its implicit form: derivatives of\nID at the " ...
                       "accelerations, M by L*D*L', cse) and over Pinocchio's\n" ...
                       "computeABADerivatives. Operations mul + add + div with loops; errors: " ...
                       "median, worst of random states."], ...
                      {"system", "mode", "JAC", "JAC : least", "JAC : CasADi", ...
                       "JAC : Pinocchio", "operations", "CasADi", "error", "CasADi's"}, lines);
end

function t = worst_words (e)
  t = "-";
  if (! isempty (e))
    t = sprintf ("%.1e, %.1e", e(1).median, e(1).worst);
  end
end

function t = cpu (seconds)
  t = "stopped";
  if (isfinite (seconds))
    t = sprintf ("%.2f", seconds);
  end
end

function text = batches (results)
  rows = {};
  for s = results
    for m = s.modes
      row = {s.name, m{1}};
      for w = {"id", "fd", "mm"}
        one = speed_pick (s.times, "gsmbp_batch", m{1}, w{1});
        row = [row, ...
               {spread(one), ...
                number("%.2f", ...
                       speed_ratio (s.times, {"gsmbp_batch", m{1}}, {"gsmbp", m{1}}, w{1}))}];
      end
      if (any (! strcmp (row(3:2:end), "-")))
        rows{end+1} = row;
      end
    end
  end
  text = speed_table ("Batches", ...
                      "ns for one state of a batch of 256, and over the time of a single call.", ...
                      {"system", "mode", "ID", "batch : single", "FD", "batch : single", "M", ...
                       "batch : single"}, rows);
end

function text = errors (results)
  text = "";
  columns = {"gsmbp", "lit"; "gsmbp", "num"; "gsmbp_batch", "lit"; "casadi", "lit"; "casadi", ...
             "num"; "sympy", "lit"; "pinocchio", "num"; "mujoco_lean", "num"; "newton_euler", ...
             "quad"};
  for kind = ...
      {"random", "fast", "singular"; ["1000 random states, q' to 2 rad/s, q'' to 5 rad/s^2, " ...
                                      "torques to 10 N*m"], "speeds up to 2e4 rad/s", ...
                                          "every joint within 1e-7 of stretched or folded"
              "CasADi's code in the same mode", "the best rival", "the best rival"}
    lines = {};
    for s = results
      for w = {"id", "fd"}
        e = s.errors(strcmp ({s.errors.kind}, kind{1}));
        found = arrayfun (@(k) speed_pick (e, columns{k,:}, w{1}), 1:rows (columns), ...
                          "UniformOutput", false);
        worst = cellfun (@worst_of, found);
        row = {s.name, toupper(w{1})};
        for k = 1:numel (found)
          row{end+1} = "-";
          if (isfinite (worst(k)))
            row{end} = sprintf ({"%.1e, %.1e", "%.1e, **%.1e**"}{1 ...
                                    + (k < 4 && worst(k) > bound(kind{1}, worst, k))}, ...
                                found{k}.median, worst(k));
          end
        end
        lines{end+1} = row;
      end
    end
    head = ["Relative errors (2-norm) against the quad build: median, worst; " kind{2} ...
            ". Bold: worst of ours above 1e-15 and more than a tenth above that of " kind{3} ...
            ".\nThe last column: the quad build itself against Newton-Euler equations of their " ...
            "own in quad precision."];
    text = [text, speed_table(["Errors, " kind{1} " states"], head, ...
      {"system", "", "ours lit", "ours num", "batch", "CasADi lit", "CasADi num", "SymPy", ...
       "Pinocchio", "MuJoCo", "quad build"}, lines)];
  end
end

## what the worst error of column K may be: 1e-15, or a tenth above CasADi's in the same mode on
## random states, else above the best rival's
function b = bound (kind, worst, k)
  b = max (1e-15, 1.1 * min (worst(4:8)));
  if (strcmp (kind, "random"))
    b = max (1e-15, 1.1 * worst([4 5 4](k)));
  end
end

function w = worst_of (x)
  w = Inf;
  if (! isempty (x))
    w = x(1).worst;
  end
end

## exponents between neighbours of a family
function text = growth (results)
  rows = {};
  for family = {"spat", "pend"}
    list = results(cellfun (@(n) ! isempty (regexp (n, ['^' family{1} '\d+$'])), {results.name}));
    for k = 2:numel (list)
      a = list(k-1);
      b = list(k);
      p = @(x, y) number ("%.1f", log (y / x) / log (b.n / a.n));
      o = @(s, w) total (s.operations.lit.(w));
      t = @(s, w) first_of (speed_pick (s.times, "gsmbp", "lit", w));
      rows{end+1} = {sprintf("%s to %s", a.name, b.name), p(seconds (a, "all"), ...
          seconds (b, "all")), p(seconds (a, "LIN"), seconds (b, "LIN")), p(a.compile.lit, ...
          b.compile.lit), p(o(a, "inv"), o(b, "inv")), p(o(a, "mas"), o(b, "mas")), ...
        p(o(a, "fwd"), o(b, "fwd")), p(o(a, "lin"), o(b, "lin")), p(t(a, "id"), ...
            t(b, "id")), p(t(a, "fd"), t(b, "fd")), p(t(a, "lin"), t(b, "lin"))};
    end
  end
  text = speed_table ("Growth with n", "Exponents of n between neighbours: 1 is linear.", ...
                      {"", "derivation", "of LIN", "compilation", "ID operations", "M", "FD", ...
                       "LIN", "ID time", "FD time", "LIN time"}, rows);
end

function text = passes (results)
  rows = {};
  words = {"inv", "mas", "fwd", "lin"};
  for s = results
    for k = 1:numel (s.passes)
      gain = repmat ({""}, 1, 4);
      if (k > 1 && strcmp (s.passes(k).mode, s.passes(k-1).mode))
        gain = cellfun (@(w) number ("%+d", s.passes(k).(w) - s.passes(k-1).(w)), words, ...
                        "UniformOutput", false);
      end
      rows{end+1} = [{s.name, s.passes(k).mode, s.passes(k).word}, ...
                     cellfun(@(w) number ("%d", s.passes(k).(w)), words, "UniformOutput", ...
                             false), gain];
    end
  end
  text = ...
      speed_table ("Pass by pass", ["Operations with one pass after the other switched on, and " ...
                                    "what each adds."],
    {"system", "mode", "pass", "ID", "M", "FD", "LIN", "ID by it", "M by it", "FD by it", ...
     "LIN by it"}, rows);
end
