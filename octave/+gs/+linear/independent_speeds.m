## [T, c, k] = gs.linear.independent_speeds (who, what, m, t, q, u, names)
## The motion of a closed chain by some of its speeds: ud = T*ud(k) + c where the constraints hold,
## and u = T*u(k) where time does not move them.  NAMES: of as many coordinates, or speeds, as there
## are freedoms; k: their numbers.  WHAT: how the user of WHO calls them.

function [T, c, k] = independent_speeds (who, what, m, t, q, u, names)
  k = cellfun (@(name) number (who, what, m, name), cellstr (names)(:)');
  n = m.sizes.nu;
  if (numel (unique (k)) != numel (k))
    error ("%s: %s: a name is given twice: %s", who, what, ...
           strjoin (cellstr (names)(:)', ", "));
  endif
  rest = setdiff (1:n, k);
  T = zeros (n, numel (k));
  T(k,:) = eye (numel (k));
  c = zeros (n, 1);
  if (m.sizes.nlam == 0)
    freedoms = n;
    bad = numel (k) != n;
  else
    [~, ~, H, gam] = m.con (t, q, u);
    length_ = sqrt (sum (H .^ 2, 2));
    length_(length_ == 0) = 1;
    H ./= length_;
    s = svd (H);
    rank_ = sum (s > 1e-10 * max (s));
    freedoms = n - rank_;
    d = svd (H(:,rest));
    bad = numel (k) != freedoms || sum (d > 1e-10 * max (s)) < numel (rest);
  endif
  if (bad)
    found = strjoin (cellstr (names)(:)', ", ");
    found = {found, "none"}{1 + isempty(found)};
    error (["%s: %s: expected %d of the coordinates, from which the motion of the others " ...
            "follows here; found %s"], who, what, freedoms, found);
  endif
  if (! isempty (rest))
    T(rest,:) = -H(:,rest) \ H(:,k);
    c(rest) = H(:,rest) \ (gam ./ length_);
  endif
endfunction

function k = number (who, what, m, name)
  k = find (strcmp (name, m.speeds));
  if (isempty (k))
    k = find (strcmp ([name "_d"], m.speeds));
  endif
  if (isempty (k))
    error ("%s: %s: unknown coordinate %s", who, what, ...
           gs.text.nearest_word (name, m.coordinates));
  endif
endfunction
