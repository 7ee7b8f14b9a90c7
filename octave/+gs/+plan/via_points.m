## motion = gs.plan.via_points (who, kind, q, times, pairs)
## Through or near via points, the columns of Q, at TIMES: KIND "cubic", splines of order three
## with given speeds at the ends (none: their second derivatives vanish); "blends", straight
## lines and parabolas between them.

function motion = via_points (who, kind, q, times, pairs)
  [n, k] = deal (rows (q), numel (times));
  if (strcmp (kind, "cubic"))
    o = gs.given.call_options (who, {"start", [], "numbers"; "end", [], "numbers"}, pairs);
    motion = cubic (q, times, ends_of (who, "start", o.start, n), ends_of (who, "end", o.end, n));
    return;
  endif
  o = gs.given.call_options (who, {"acceleration", [], "numbers"}, pairs);
  a = o.acceleration(:);
  if (isscalar (a))
    a = repmat (a, n, 1);
  endif
  if (numel (a) != n || ! all (a > 0))
    error ("%s: option acceleration: expected one number or %d numbers above 0, found %s", who, ...
           n, gs.text.shown_value (o.acceleration));
  endif
  for i = 1:n
    laws(i) = blends (who, i, q(i,:), times, double (a(i)));
  endfor
  motion = gs.plan.law_pieces (laws, q(:,1), times(1));
endfunction

function v = ends_of (who, name, v, n)
  if (! (isempty (v) || numel (v) == n))
    error ("%s: option %s: expected %d speeds, found %s", who, name, n, gs.text.shown_value (v));
  endif
  v = double (v(:)');
endfunction

## slopes at the points from the continuity of the second derivative
function motion = cubic (q, times, first, last)
  [n, k] = deal (rows (q), numel (times));
  h = diff (times)(:);
  slope = diff (q, 1, 2)' ./ h;
  A = zeros (k);
  b = zeros (k, n);
  for j = 2:k-1
    A(j,j-1:j+1) = [h(j), 2*(h(j-1) + h(j)), h(j-1)];
    b(j,:) = 3 * (h(j) * slope(j-1,:) + h(j-1) * slope(j,:));
  endfor
  [A(1,1:2), b(1,:)] = at_end (first, slope(1,:));
  [A(k,k:-1:k-1), b(k,:)] = at_end (last, slope(k-1,:));
  d = A \ b;
  c2 = (3 * slope - 2 * d(1:end-1,:) - d(2:end,:)) ./ h;
  c3 = (d(1:end-1,:) + d(2:end,:) - 2 * slope) ./ h.^2;
  motion = mkpp (times, cat (3, c3', c2', d(1:end-1,:)', q(:,1:end-1)), n);
endfunction

function [row, right] = at_end (speed, slope)
  [row, right] = deal ([2, 1], 3 * slope);
  if (! isempty (speed))
    [row, right] = deal ([1, 0], speed);
  endif
endfunction

## straight lines, joined by parabolas of acceleration A about the via points; at both ends the
## parabola begins and ends at rest, its middle as far from the end as half of it lasts
function law = blends (who, i, q, times, a)
  k = numel (q);
  h = diff (times);
  d = diff (q);
  speed = d ./ h;
  for j = unique ([1, k - 1])
    both = 1 + (k == 2);
    root = h(j)^2 - 2 * both * abs (d(j)) / a;
    too_fast (who, i, root < 0, times(j), times(j+1));
    blend = (h(j) - sqrt (root)) / both;
    speed(j) = d(j) / (h(j) - blend * both / 2);
  endfor
  jumps = diff ([0, speed, 0]);
  lasts = abs (jumps) / a;
  centre = [times(1) + lasts(1) / 2, times(2:end-1), times(end) - lasts(end) / 2];
  straight = diff (centre) - (lasts(1:end-1) + lasts(2:end)) / 2;
  for j = find (straight < -8 * eps * times(end))
    too_fast (who, i, true, times(j), times(j+1));
  endfor
  durations = [lasts; [max(0, straight), 0]](:)(1:end-1)';
  law = struct ("durations", durations, "jerks", 0 * durations, "T", times(end) - times(1));
  law.accelerations = [sign(jumps) * a; zeros(1, k)](:)(1:end-1)';
  [law.switch_q, law.switch_v] = deal (zeros (1, numel (durations) + 1));
  for p = 1:numel (durations)
    t = durations(p);
    law.switch_v(p+1) = law.switch_v(p) + law.accelerations(p) * t;
    law.switch_q(p+1) = law.switch_q(p) + law.switch_v(p) * t + law.accelerations(p) * t^2 / 2;
  endfor
endfunction

function too_fast (who, i, wrong, from, to)
  if (wrong)
    error (["%s: coordinate %d: the blends from t = %g s to %g s overlap: expected a larger " ...
            "acceleration or more time"], who, i, from, to);
  endif
endfunction
