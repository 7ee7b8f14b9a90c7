## [best, ends, told] = gs.optimize.try_choices (who, P, o)
## The best end of a design over its choices from lists.  "all": every combination; "branch":
## branch and bound on the order of the numbers: a choice that is free between two numbers of its
## list can only be better than those between them, and what is no better than the best found is not
## looked at.  TOLD: how (a word), combinations, solved (problems), limit, open (the best that an
## unsolved rest may reach).

function [best, ends, told] = try_choices (who, P, o)
  lists = {P.free(! cellfun (@isempty, {P.free.list})).list};
  told = struct ("how", o.choices, "combinations", prod (cellfun (@numel, lists)), "solved", 0, ...
                 "limit", false, "open", Inf, "stopped", "");
  if (strcmp (o.choices, "auto"))
    told.how = merge (told.combinations > 100, "branch", "all");
  endif
  if (strcmp (told.how, "all"))
    [best, ends, told] = every_one (who, P, o, lists, told);
  else
    [best, ends, told] = branched (who, P, o, lists, told);
  endif
endfunction

function [best, ends, told] = every_one (who, P, o, lists, told)
  if (told.combinations > 1000)
    error (["%s: option choices: expected at most 1000 combinations for \"all\", found %d; " ...
            "\"branch\" looks at fewer"], who, told.combinations);
  endif
  best = [];
  ends = none ();
  list = combinations (lists);
  for k = 1:rows (list)
    if (k > 1 && time () >= o.ends)
      told.stopped = "timeout";
      break;
    endif
    [one, here, failed] = tried (who, gs.optimize.choice_points (P, list(k,:), list(k,:)), o);
    ends = [ends, here];
    told.solved++;
    if (isempty (failed) && better (one, best))
      best = one;
    endif
    told.stopped = ended (one, failed, o);
    if (! isempty (told.stopped))
      break;
    endif
  endfor
  if (isempty (best) && (isempty (told.stopped) || told.combinations == 1))
    rethrow (failed);
  endif
  best = stopped (who, best, told, o);
endfunction

## what ended a problem from outside
function word = ended (one, failed, o)
  word = gs.optimize.cut_word (failed, o);
  if (isempty (failed))
    word = one.stopped;
  endif
endfunction

## a problem solved, or why it cannot be calculated where it begins, or what ended it there
function [one, ends, failed] = tried (who, Q, o)
  failed = one = [];
  try
    [one, ends] = gs.optimize.solve_design (who, Q, o);
  catch failed
    ends = none ();
    if (! isempty (gs.optimize.cut_word (failed, o)))
      return;
    endif
    values = Q.given;
    for f = Q.free
      values.(strrep (f.name, ".", "_")) = f.start;
    endfor
    ends(1) = struct ("values", values, "J", NaN, "solved", false, "violation", NaN, ...
                      "ended", ["no start: " failed.message]);
  end_try_catch
endfunction

function list = combinations (lists)
  list = zeros (1, 0);
  for one = lists
    n = rows (list);
    list = [repmat(list, numel (one{1}), 1), kron(one{1}(:), ones (n, 1))];
  endfor
endfunction

function [best, ends, told] = branched (who, P, o, lists, told)
  n = cellfun (@numel, lists);
  open = struct ("from", ones (size (n)), "to", n, "bound", -Inf, "start", [P.free.start]);
  best = [];
  ends = none ();
  refused = why = [];
  while (! isempty (open))
    [told.open, k] = min ([open.bound]);   # the best bound first
    if (! worth (told.open, best))
      break;
    elseif (told.solved > 0 && time () >= o.ends)
      told.stopped = "timeout";
      told.limit = true;
      break;
    elseif (told.solved >= o.nodes)
      told.limit = true;
      break;
    endif
    node = open(k);
    open(k) = [];
    [one, here, failed, values] = solved (who, P, o, lists, node);
    told.solved++;
    whole = all (node.from == node.to);
    told.stopped = ended (one, failed, o);
    if (! isempty (told.stopped))
      told.limit = true;
      if (whole && isempty (failed) && worth (one.e.J, best) && one.violation <= 1e-6)
        best = one;
      endif
      break;
    endif
    if (whole)
      ends = [ends, here];
    endif
    if (! isempty (failed))   # nothing is known of it: its halves
      why = failed;
      if (! whole)
        open = [open, halves(P, lists, node, node.bound, node.start, false)];
      endif
    elseif (one.violation > 1e-6)
      if (better (one, refused))
        refused = one;
      endif
    elseif (! one.solved && ! whole)
      open = [open, halves(P, lists, node, node.bound, values, false)];
    elseif (worth (one.e.J, best))
      if (whole)
        best = one;
      else
        open = [open, halves(P, lists, node, one.e.J, values, true)];
      endif
    endif
  endwhile
  if (! told.limit)
    told.open = Inf;
  endif
  if (isempty (best) && isempty (told.stopped))
    best = refused;
  endif
  if (isempty (best) && ! told.limit)
    rethrow (why);
  endif
  best = stopped (who, best, told, o);
endfunction

## the end that a limit leaves, if any
function best = stopped (who, best, told, o)
  if (! isempty (told.stopped))
    if (isempty (best))
      error ("gsmbp:stopped", "%s: %s before a combination of choices was completed", who, ...
             gs.run.stopped_text (told.stopped));
    endif
    [best.stopped, best.limit, best.solved] = deal (told.stopped, true, false);
    best.ended = gs.run.stopped_text (told.stopped);
    if (told.combinations > 1)
      best.ended = sprintf ("%s after %d problems for %d combinations of choices", best.ended, ...
                            told.solved, told.combinations);
    endif
  elseif (isempty (best) && told.limit)
    error (["%s: no combination of choices was completed within the limit of %d problems " ...
            "(option nodes); the best may reach %g"], who, o.nodes, told.open);
  elseif (told.limit)
    best.limit = true;
    best.solved = false;
    best.ended = sprintf (["stopped at the limit of %d problems (option nodes); other choices " ...
                           "may reach %.9g"], o.nodes, told.open);
  endif
endfunction

function yes = worth (bound, best)
  yes = isempty (best) || bound < best.e.J - 1e-9 * max (1, abs (best.e.J));
endfunction

## a node: choices free between two places of their lists; VALUES: of all free variables at its end
function [one, ends, failed, values] = solved (who, P, o, lists, node)
  low = arrayfun (@(k) lists{k}(node.from(k)), 1:numel (lists));
  high = arrayfun (@(k) lists{k}(node.to(k)), 1:numel (lists));
  Q = gs.optimize.choice_points (P, low, high, node.start);
  [one, ends, failed] = tried (who, Q, o);
  if (isempty (failed) && one.violation > 1e-6 && any (node.from < node.to))
    [again, ~, lost] = tried (who, Q, setfield (o, "solver", other (one.solver)));
    if (isempty (lost) && better (again, one))
      one = again;
    elseif (! isempty (gs.optimize.cut_word (lost, o)))
      failed = lost;
    endif
  endif
  values = node.start;
  values(! cellfun (@isempty, {P.free.list})) = low;
  [~, place] = ismember ({Q.free.name}, {P.free.name});
  if (isempty (failed))
    values(place) = one.p;
  endif
endfunction

## another solver, for a problem that seems to have no solution
function word = other (word)
  word = merge (strcmp (word, "ipopt") && exist ("nlopt_optimize", "file"), "slsqp", "ipopt");
endfunction

## both sides of the choice that lies farthest between two numbers of its list; where all lie on
## one at a solution (KNOWN), that combination alone, which is the best of them
function list = halves (P, lists, node, bound, values, known)
  at = values(! cellfun (@isempty, {P.free.list}));
  far = zeros (size (at));
  list = repmat (setfield (setfield (node, "bound", bound), "start", values), 1, 2);
  for k = find (node.from < node.to)
    here = lists{k}(node.from(k):node.to(k));
    below(k) = node.from(k) - 1 + max (1, min (sum (here <= at(k)), numel (here) - 1));
    step = lists{k}(below(k)+1) - lists{k}(below(k));
    share = min (max ((at(k) - lists{k}(below(k))) / step, 0), 1);
    up(k) = share > 0.5;
    far(k) = 1e-12 + min (share, 1 - share);
  endfor
  [most, k] = max (far);
  if (known && most < 1e-9)
    i = node.from < node.to;
    node.from(i) = below(i) + up(i);
    list = setfield (list(1), "from", node.from);
    list.to = node.from;
    return;
  endif
  list(1).to(k) = below(k);
  list(2).from(k) = below(k) + 1;
endfunction

function list = none ()
  list = struct ("values", {}, "J", {}, "solved", {}, "violation", {}, "ended", {});
endfunction

## whether an end is to be preferred
function yes = better (a, b)
  yes = isempty (b);
  if (! yes)
    [fa, fb] = deal (a.violation <= 1e-6, b.violation <= 1e-6);
    yes = (fa && ! fb) || (fa == fb && ((fa && a.e.J < b.e.J) ...
                                        || (! fa && a.violation < b.violation)));
  endif
endfunction
