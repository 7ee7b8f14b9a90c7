## kept = gs.sweep.kept_results (who, m, words, times)
## What WORDS, as "peak motor.i", keep of a run of the model M at TIMES: a struct array with what,
## name, unit; of (t, z), a number for each column of z, a row for each time t (of a whole run, all
## of z; of events of (counted), of margins of devices of (margins), of an ensemble); whole; and for
## the program of a sweep the numbers of the way, the quantity, the time.  A margin of a control
## loop has the way 0, what is kept of events and of margins of devices one above 8.

function kept = kept_results (who, m, words, times)
  if (isempty (words))
    words = cellfun (@(name) ["final " name], {m.outputs, m.states}{1 + isempty(m.outputs)}(:)', ...
                     "UniformOutput", false);
  endif
  names = [m.states(:); m.inputs(:); m.outputs(:)]';
  units = [m.units.states(:); m.units.inputs(:); m.units.outputs(:)]';
  kept = struct ("what", {}, "name", {}, "unit", {}, "of", {}, "whole", {}, "way", {}, "number", ...
                 {}, "time", {});
  words = once (who, cellstr (words)(:)');
  for word = words
    at = find (strcmp (word{1}, margins ()(:,1)));
    if (at)
      kept(end+1) = struct ("what", word{1}, "name", word{1}, "unit", margins (){at,2}, "of", ...
                            [], "whole", false, "way", 0, "number", 0, "time", 0);
      continue;
    endif
    if (! isempty (regexp (word{1}, '^state_margin\d+$', "once")))
      kept(end+1) = of_margin (who, m, word{1});
      continue;
    endif
    [way, name, at] = parts_of (who, word{1}, times);
    number = find (strcmp (ways (), way));
    if (number > 8)
      kept(end+1) = of_events (who, m, word{1}, name, number);
      continue;
    endif
    k = find (strcmp (names, name), 1);
    if (isempty (k))
      error ("%s: option keep: unknown %s", who, gs.text.nearest_word (name, names));
    endif
    kept(end+1) = struct ("what", word{1}, "name", name, "unit", units{k}, "of", ...
                          of (way, at), "whole", strcmp (way, "whole"), "way", ...
                          number, "number", k, "time", at);
  endfor
endfunction

## each of the words, without a blank too many, is there once
function words = once (who, words)
  words = regexprep (strtrim (words), '\s+', " ");
  [~, first] = unique (words, "first");
  again = setdiff (1:numel (words), first);
  if (! isempty (again))
    error ("%s: option keep: \"%s\" is given twice", who, words{again(1)});
  endif
endfunction

function list = margins ()
  list = {"phase_margin", "rad"; "gain_margin", "1"; "delay_margin", "s"; "Ms", "1"};
endfunction

function list = ways ()
  list = {"final", "peak", "max", "min", "mean", "rms", "at", "whole", "first", "last", "count"};
endfunction

## the way, the name, the number of the time
function [way, name, at] = parts_of (who, word, times)
  at = numel (times);
  parts = regexp (strtrim (word), '^(\w+)\s+(.*)$', "tokens", "once");
  if (isempty (parts) || ! any (strcmp (parts{1}, ways ())))
    error (["%s: option keep: expected one of %s and a name, or one of %s, state_margin and a " ...
            "number, found %s"], who, strjoin (ways (), ", "), ...
           strjoin (margins ()(:,1)', ", "), gs.text.shown_value (word));
  endif
  [way, name] = parts{:};
  if (! strcmp (way, "at"))
    return;
  endif
  parts = regexp (name, '^(\S+)\s+(.*)$', "tokens", "once");
  t = NaN;
  if (! isempty (parts))
    [t, name] = deal (str2double (parts{1}), parts{2});
  endif
  [off, at] = min (abs (times - t));
  if (! (off <= 1e-12 * max (abs (times))))
    error ("%s: option keep: expected one of the times and a name behind \"at\", found %s", who, ...
           gs.text.shown_value (word));
  endif
endfunction

## the least value of a margin of the devices
function kept = of_margin (who, m, word)
  k = str2double (word(13:end));
  n = numel (m.state_margins);
  if (k < 1 || k > n)
    error ("%s: option keep: %s: expected the number of a margin (m.state_margins), %s", who, ...
           word, {sprintf("1 to %d", n), "of which there is none"}{1 + (n == 0)});
  endif
  kept = struct ("what", word, "name", m.state_margins{k}, "unit", "", "of", ...
                 @(least) least(:,k), "whole", false, "way", 12, "number", k, "time", 1);
endfunction

## the time of the first or last event with the NAME, or how many there are
function kept = of_events (who, m, word, name, way)
  names = {m.events.name};
  k = find (strcmp (names, name), 1);
  if (isempty (k))
    way_out = "";
    if (any (strcmp (name, [m.states(:); m.inputs(:); m.outputs(:)])))
      way_out = sprintf (["; \"%s\" is a quantity: write \"final %s\" (\"first\", \"last\" and " ...
                          "\"count\" are of events)"], name, name);
    endif
    error ("%s: option keep: unknown event %s%s", who, gs.text.nearest_word (name, ...
        unique (names)), way_out);
  endif
  mine = gs.events.group_names (m) == k;
  parts = {@(c) min(c.first(:,mine), [], 2), @(c) max(c.last(:,mine), [], 2), ...
           @(c) sum(c.count(:,mine), 2)};
  kept = struct ("what", word, "name", name, "unit", {"s", "s", "1"}{way-8}, "of", parts{way-8}, ...
                 "whole", false, "way", way, "number", k, "time", 1);
endfunction

function f = of (way, at)
  switch (way)
    case {"final", "at"}
      f = @(t, z) z(at,:);
    case "peak"
      f = @(t, z) max (abs (z), [], 1);
    case "max"
      f = @(t, z) max (z, [], 1);
    case "min"
      f = @(t, z) min (z, [], 1);
    case "mean"
      f = @mean_of;
    case "rms"
      f = @(t, z) sqrt (mean_of (t, z .* z));
    case "whole"
      f = @(t, z) z;
  endswitch
endfunction

## the trapezoidal rule, one interval after the other: the same bits wherever it is done
function s = mean_of (t, z)
  s = zeros (1, columns (z));
  for k = 2:numel (t)
    s = s + (t(k) - t(k-1)) * (z(k,:) + z(k-1,:));
  endfor
  s = s / (2 * (t(end) - t(1)));
endfunction
