## lines = before_differ (m, then, now, whole)
## Say how the run NOW of the model M differs from THEN (before_run), sentences in a row of cells,
## empty if nothing does; if not WHOLE, in INFO, identifiers of errors and warnings alone.
## Equal must be: INFO, identifiers and texts of errors, identifiers of
## warnings, number, names, order and modes of events. Of a run that failed on its way rounding
## makes the numbers: its message has the same words up to the margins that it has passed, the time
## is within a tenth. States and times of events: within ten times the error of THEN
## (before_record), which is at least the tolerance of the run, 1e-10, or 1e-13 with fixed steps,
## which rounding does not change. Calls, steps, failed steps, projections: within a tenth of the
## steps (calls: of the calls) and 20 (300); where there are no events equal with rk4, steps also
## with gauss.

function lines = before_differ (m, then, now, whole)
  lines = {};
  for field = {"info", "id", "warned", "happened", "events"}(1:3+2*whole)
    [a, b] = deal (then.(field{1}), now.(field{1}));
    if (! isequal (a, b) && ! (isempty (a) && isempty (b)))
      lines{end + 1} = sprintf ("%s: expected %s, found %s", field{1}, shown (a), shown (b));
    end
  end
  if (! whole)
    return;
  end
  number = '-?\d+\.?\d*(e[-+]?\d+)?|-?(NaN|Inf)';
  words = @(text) regexprep (text, {"; outside a margin.*", number}, {"", "#"});
  if (isempty (then.info))
    words = @(text) text;
  end
  if (! strcmp (words (then.text), words (now.text)))
    lines{end + 1} = sprintf ("expected \"%s\", found \"%s\"", then.text, now.text);
  end
  if (isempty (then.info) || ! isempty (lines))
    return;
  end
  lines = counted (then, now);
  if (then.info == 0)
    lines = [lines, numbers(m, then, now)];
  elseif (abs (then.reached - now.reached) > 0.1 * abs (then.reached))
    lines{end + 1} = sprintf ("reached: expected %g s, found %g s", then.reached, now.reached);
  end
end

function text = shown (value)
  text = disp (value)(1:end-1);
end

function lines = counted (then, now)
  lines = {};
  most = [300, 20, 20, 20] + 0.1 * then.counts([1, 2, 2, 2]);
  if (then.happened == 0)
    most(2:3) *= ! strncmp (then.name, "gauss", 5);
    most *= ! strncmp (then.name, "rk4", 3);
  end
  if (any (abs (then.counts - now.counts) > most))
    lines{1} = sprintf ("calls, steps, failed steps, projections: expected%s, found%s", ...
                        sprintf (" %d", then.counts), sprintf (" %d", now.counts));
  end
end

function lines = numbers (m, then, now)
  lines = {};
  least = {1e-10, 1e-13}{1 + any(strncmp (then.name, {"rk4", "gauss"}, 3))};
  allowed = 10 * max (least, then.error);
  allowed(isnan (then.error)) = 1e-6;
  if (numel (then.x) != numel (now.x))
    lines{1} = sprintf ("x: expected %d numbers, found %d", numel (then.x), numel (now.x));
    return;
  end
  e = before_distance (m, then, now);
  found = {"the last state", "the times of events"};
  for k = find (! (e <= allowed))
    lines{end + 1} = sprintf ("%s: expected within %.1e, found %.1e", found{k}, allowed(k), e(k));
  end
end
