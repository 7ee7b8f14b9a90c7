## [motion, laws] = gs.plan.limited_motion (who, q, pairs, jerk)
## Moves from column to column of Q within limits of speed and acceleration, of jerk where JERK
## is true: a piecewise polynomial, and the law (as of gs.plan.speed_profile) of each coordinate
## (row) and move (column).

function [motion, laws] = limited_motion (who, q, pairs, jerk)
  [n, k] = deal (rows (q), columns (q));
  if (k < 2)
    error ("%s: expected two columns of positions or more, found %d x %d", who, n, k);
  endif
  o = limits (who, n, pairs, jerk);
  begin = o.at;
  for p = 1:k-1
    ends = [o.start * (p == 1), o.end * (p == k - 1)];
    these = laws_of (who, o, q(:,p+1) - q(:,p), ends, n);
    parts{p} = gs.plan.law_pieces (these, q(:,p), begin);
    laws(1:n,p) = these;
    begin = parts{p}.breaks(end);
    told_back (who, these, p, k);
  endfor
  motion = gs.plan.joined_laws (parts);
endfunction

## an option that was left out is empty
function text = found (value)
  text = "none";
  if (! isempty (value))
    text = gs.text.shown_value (value);
  endif
endfunction

function o = limits (who, n, pairs, jerk)
  table = {"speed", [], "numbers"; "acceleration", [], "numbers"
           "start", 0, "numbers"; "end", 0, "numbers"; "at", 0, "number"
           "synchronized", "time", {"time", "line", "none"}};
  if (jerk)
    table(end+1,:) = {"jerk", [], "numbers"};
  endif
  o = gs.given.call_options (who, table, pairs);
  names = setdiff (table(:,1)', {"synchronized", "at"}, "stable");
  ## a value that is wrong is told before one that is missing
  left_out = cellfun (@(name) isempty (o.(name)), names);
  for name = [names(! left_out), names(left_out)]
    value = double (o.(name{1})(:));
    bound = any (strcmp (name{1}, {"speed", "acceleration", "jerk"}));
    if (isscalar (value))
      value = repmat (value, n, 1);
    endif
    if (numel (value) != n || (bound && ! all (value > 0)))
      wanted = {"one number", sprintf("one number or %d numbers", n)}{1 + (n > 1)};
      error ("%s: option %s: expected %s%s, found %s", who, name{1}, wanted, ...
             {"", " above 0"}{1 + bound}, found (o.(name{1})));
    endif
    o.(name{1}) = value;
  endfor
  if (! jerk)
    o.jerk = Inf (n, 1);
  endif
endfunction

## one move: a law for each coordinate, h long
function laws = laws_of (who, o, h, ends, n)
  for i = find (max (abs (ends), [], 2) > o.speed)'
    error ("%s: coordinate %d: expected a speed within %g at start and end, found %g and %g", ...
           who, i, o.speed(i), ends(i,1), ends(i,2));
  endfor
  if (strcmp (o.synchronized, "line"))
    laws = along_a_line (who, o, h, ends);
    return;
  endif
  for i = 1:n
    laws(i) = gs.plan.speed_profile (h(i), ends(i,1), ends(i,2), o.speed(i), o.acceleration(i), ...
                                     o.jerk(i));
  endfor
  T = max ([laws.T]);
  if (strcmp (o.synchronized, "time"))
    for i = find ([laws.T] < T)
      laws(i) = gs.plan.delayed_law (who, laws(i), T, i);
    endfor
  endif
endfunction

## all coordinates follow one law from 0 to 1, within the limits of each
function laws = along_a_line (who, o, h, ends)
  if (any (ends(:) != 0))
    error ("%s: option synchronized = \"line\" takes a move from rest to rest, found %s", who, ...
           sprintf ("speeds %s", mat2str (ends, 6)));
  endif
  size_of = abs (h);
  moved = size_of > 0;
  if (! any (moved))
    law = gs.plan.speed_profile (0, 0, 0, 1, 1, o.jerk(1));
  else
    least = @(limit) min (limit(moved) ./ size_of(moved));
    law = gs.plan.speed_profile (1, 0, 0, least (o.speed), least (o.acceleration), least (o.jerk));
  endif
  for i = 1:numel (h)
    laws(i) = law;
    for field = {"switch_q", "switch_v", "peak", "jerks", "accelerations"}
      laws(i).(field{1}) = h(i) * law.(field{1});
    endfor
  endfor
endfunction

function told_back (who, laws, p, k)
  for i = find ([laws.retraces])
    if (all (laws(i).given(1) * laws(i).given(2:3) >= 0))
      warning ("gsmbp:plan", ...
               ["%s: coordinate %d goes back in move %d of %d: the way of %g is too short for " ...
                "the speeds at its ends"], who, i, p, k - 1, ...
               laws(i).switch_q(end) - laws(i).switch_q(1));
    endif
  endfor
endfunction
