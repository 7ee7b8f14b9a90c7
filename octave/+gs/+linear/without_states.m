## keep = gs.linear.without_states (who, m, t, x, v, names, A, k)
## Which of the states of the numbers K are left where coordinates are dropped: those of NAMES, or
## where that is "running" all that change at the state X; and those that only follow them.  A: the
## Jacobian of the rates of these states.  An error of WHO where anything that is left depends on
## them, here or further on.

function keep = without_states (who, m, t, x, v, names, A, k)
  d = m.sizes;
  if (ischar (names) && strcmp (names, "running"))
    rate = m.rhs (t, x, v)(1:d.nq);
    gone = find (abs (rate) > 1e-9 * m.nominal(1:d.nq))';
  else
    names = cellstr (names)(:)';
    gone = vec (gs.given.places_of (names, m.coordinates), 2);
    if (! all (gone))
      error ("%s: option \"drop\": expected the name of a coordinate or \"running\", found %s", ...
             who, gs.text.nearest_word (names{find (! gone, 1)}, m.coordinates));
    endif
  endif
  size_ = m.nominal(k);
  row = max (abs (A) .* size_', [], 2);
  mechanical = (k <= d.nq + d.nu)';
  least = 1e-11 * max ([row(mechanical); 0]) * mechanical;   # rounding, where a row is zero
  D = abs (A) .* size_' > max (1e-9 * row, max (least, 1e-18 * size_));
  keep = ! ismember (k, gone);
  do   # what depends on them, and carries nothing else along
    more = keep & k <= d.nq & any (D(:,! keep), 2)' & ! any (D & keep', 1);
    keep(more) = false;
  until (! any (more))
  refuse_any (who, m, k, D, keep);
  check_further_on (who, m, t, x, v, A, k, keep);
endfunction

function refuse_any (who, m, k, D, keep)
  [i, j] = find (D & keep' & ! keep);
  if (! isempty (i))
    error (["%s: %s: %s cannot be dropped: the rate of %s depends on it; only what nothing " ...
            "depends on can be (a coordinate that is ignorable)"], who, m.name,
           m.states{k(j(1))}, m.states{k(i(1))});
  endif
endfunction

## the same matrix where what is dropped has moved
function check_further_on (who, m, t, x, v, A, k, keep)
  d = m.sizes;
  q = k(k <= d.nq);
  u = k(k > d.nq & k <= d.nq + d.nu) - d.nq;
  gone = k(! keep);
  y = x;
  y(gone) += 0.618 * m.nominal(gone);
  y = gs.linear.follow_rest (m, t, y, q, u);
  [T, own] = gs.linear.loop_tangent (who, m, t, y, k, zeros (0, 2));
  E = m.jac (t, y, v)(own,:) * T;
  away = abs (E - A)(keep,keep) .* m.nominal(k(keep))';
  limit = 1e-7 * max (max (abs (A(keep,keep)) .* m.nominal(k(keep))', [], 2), m.nominal(k(keep)));
  [i, j] = find (away > limit, 1);
  if (! isempty (i))
    error (["%s: %s: %s cannot be dropped: what the rate of %s has of %s changes with it, the " ...
            "motion is not steady there"], who, m.name, strjoin (m.states(gone)', ", "), ...
           m.states{k(keep)(i)}, m.states{k(keep)(j)});
  endif
endfunction
