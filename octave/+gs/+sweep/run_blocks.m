## r = gs.sweep.run_blocks (who, s, j)
## The runs of a sweep, some at a time: they need not fit into memory.  S: m, times, plan (that of
## one run, gs.run.plan_many), names, table, kept, threads, lanes, chunk, loop; J: a journal, []
## for none.  R: values, ok, reached, reason, whole (a cell, a matrix for each whole run that is
## kept), seconds, made (whether they were), stopped ("", or what ended all; of the chunk under way
## the runs that came to their end before are kept), outside (a row for each run that was made now
## in which devices left their margins: its number, that of the first of these margins), sharp (of
## these runs the ports of gs.events.sharp_ports).

function r = run_blocks (who, s, j)
  n = rows (s.table);
  whole = [s.kept.whole];
  r = struct ("values", NaN (n, nnz (! whole)), "ok", false (n, 1), "reached", NaN (n, 1), ...
              "reason", {repmat({""}, n, 1)}, "whole", {cell(1, nnz (whole))}, "seconds", 0, ...
              "stopped", "", "outside", zeros (0, 2), "sharp", struct ([]));
  missing = true (n, 1);
  if (! isempty (j))
    [r, missing] = read_chunks (r, j, missing);
  elseif (any (whole))
    r.whole(:) = {NaN(n, numel (s.times))};
  endif
  d = s.m.sizes;
  most = floor (4e6 / (d.nx + d.nv + d.ny + 1) / numel (s.times));
  most = min (s.chunk, max (s.threads, most));
  some = min (64, most);
  ends = time () + {s.timeout, Inf}{1 + (s.timeout == 0)};
  begin = tic ();
  before = nnz (! missing);
  while (any (missing))
    first = find (missing, 1);
    last = min ([first + some - 1, n, first - 2 + find(! [missing(first:end); false], 1)]);
    took = tic ();
    [cut, b] = s.m.module ("guarded", @() chunk (s, first:last, ends - time ()), Inf);
    if (cut)   # between runs
      r.stopped = "interrupted";
      gs.run.stopped_word (who, s.m, 9, "", false);
      break;
    endif
    r.seconds += b.seconds;
    r.outside = [r.outside; b.outside];
    r.sharp = [r.sharp, b.sharp];
    for i = stretches (b.made)   # whole chunks on disk, however short
      text = [b.lines{i(1)-1+find(! b.table(i(1):i(2),1))}, ""];
      if (! isempty (j))
        j.call ("write", j.folder, first + i(1) - 2, b.table(i(1):i(2),:), text);
      endif
      r = taken (r, first + i(1) - 1, b.table(i(1):i(2),:), text, isempty (j), numel (s.times));
      missing(first-1+(i(1):i(2))) = false;
    endfor
    r.stopped = b.stopped;
    if (! isempty (r.stopped))
      break;
    endif
    some = min (most, some * max (1, min (64, floor (1 / toc (took)))));
    how_far (who, s.m, n, before, nnz (missing), toc (begin));
  endwhile
  gs.text.tell_progress ("");
  r.made = ! missing;
  r.reason(missing) = {["not made: " r.stopped]};
endfunction

## on a terminal, where it takes long
function how_far (who, m, n, before, missing, seconds)
  done = n - before - missing;
  if (seconds > 2 && done > 0)
    gs.text.tell_progress ("%s: %s: %d of %d runs, %.0f s left", who, m.name, n - missing, n, ...
                           ceil (seconds / done * missing));
  endif
endfunction

## those that are on disk; what is not whole is made again
function [r, missing] = read_chunks (r, j, missing)
  for name = j.call ("list", j.folder)'
    [first, block, text] = j.call ("read", j.folder, name{1});
    if (first < 0)
      unlink (fullfile (j.folder, name{1}));
      continue;
    endif
    r = taken (r, first + 1, block, text, false, 0);
    missing(first+1:first+rows (block)) = false;
  endfor
endfunction

## columns: first and last of the runs in a row that were made
function pairs = stretches (made)
  edges = diff ([false; made(:); false]);
  pairs = [find(edges == 1)'; find(edges == -1)' - 1];
endfunction

## a block of runs: table, a row for each, ok, reached, what is kept, whole runs; lines, one for
## each that failed, else []; made, whether it came to an end of its own; seconds, stopped
function b = chunk (s, i, left)
  warning ("off", "gsmbp:stopped", "local");   # the sweep says it
  warning ("off", "gsmbp:events", "local");    # what is kept counts all
  for id = {"margin", "failed", "tolerance"}   # the sweep says it
    warning ("off", ["gsmbp:" id{1}], "local");
  endfor
  b = struct ("table", [], "lines", {{}}, "made", false (0, 1), "seconds", 0, "stopped", ...
              "timeout", "outside", zeros (0, 2), "sharp", struct ([]));
  if (left <= 0)
    return;
  endif
  s.plan.given.timeout = {left, 0}{1 + isinf(left)};
  e = gs.run.many_runs (s.who, s.plan, gs.sweep.run_rows (s, i));
  [b.stopped, b.seconds, b.made] = deal (e.stopped, e.seconds, ! e.cut);
  if (isfield (e, "outside"))
    k = find (any (e.outside, 2));
    [~, which] = max (e.outside(k,:), [], 2);
    b.outside = [i(k)(:), which(:)];
  endif
  if (isfield (e, "sharp") && ! isempty (e.sharp))
    b.sharp = arrayfun (@(one) setfield (one, "run", i(one.run)), e.sharp);
  endif
  kept = [s.kept(! [s.kept.whole]), s.kept([s.kept.whole])];
  parts = cell (1, numel (kept));
  if (! isempty (s.loop))
    [e, g] = margins (s, i, e);
  endif
  for k = 1:numel (kept)
    if (kept(k).way == 0)
      parts{k} = [g.(kept(k).name)]';
      continue;
    endif
    if (kept(k).way == 12)
      parts{k} = kept(k).of (e.margins);
    elseif (kept(k).way > 8)
      parts{k} = kept(k).of (e.counted);
    else
      parts{k} = kept(k).of (e.t, gs.run.ensemble_values (s.who, s.m, e.x, e.v, e.y, ...
                                                          kept(k).name)).';
    endif
    parts{k}(! (e.ok | kept(k).whole),:) = NaN;
  endfor
  b.table = [e.ok, e.reached, parts{:}];
  b.lines = cell (size (e.ok));
  for k = find (! e.ok)'
    b.lines{k} = sprintf ("%d\t%s\n", i(k), strrep (e.reason{k}, "\n", " "));
  endfor
endfunction

## margins of the loops of the runs I, a struct array; a run without them failed
function [e, g] = margins (s, i, e)
  none = struct ("phase_margin", NaN, "gain_margin", NaN, "Ms", NaN, "delay_margin", NaN);
  g = repmat (none, numel (i), 1);
  for k = find (e.ok(:))'
    try
      m = gsmbp_set (s.m, cell2struct (num2cell (s.table(i(k),:)), s.names, 2));
      g(k) = gs.control.least_margins (s.loop(m));
    catch err
      e.ok(k) = false;
      e.reason{k} = ["loop: " err.message];
    end_try_catch
  endfor
endfunction

function r = taken (r, first, block, text, with_whole, nt)
  i = first:first+rows (block)-1;
  k = columns (r.values);
  [r.ok(i), r.reached(i), r.values(i,:)] = deal (block(:,1) != 0, block(:,2), block(:,3:2+k));
  for w = 1:numel (r.whole) * with_whole
    r.whole{w}(i,:) = block(:,2+k+(w-1)*nt+(1:nt));
  endfor
  for line = strsplit (text, "\n")(1:end-1)
    parts = strsplit (line{1}, "\t");
    r.reason{str2double(parts{1})} = parts{2};
  endfor
endfunction
