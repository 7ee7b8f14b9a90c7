## g = gs.collocation.read_guess (who, m, given)
## Where gsmbp_collocate begins, checked: t (from 0 to 1; none without a guess GIVEN), x, v (a
## column for each), T; what an end without a guess is made of: start, actuated.

function g = read_guess (who, m, given)
  g = struct ("t", [], "x", [], "v", [], "T", 1, "start", m.initial, "actuated", m.actuated);
  if (! isempty (given))
    g = taken (who, m, given, g);
  endif
endfunction

function g = taken (who, m, given, g)
  for name = {"t", "x", "v"}
    if (! (isstruct (given) && isscalar (given) && isfield (given, name{1})))
      error ("%s: option guess: expected a struct with t, x, v, found %s", who, ...
             gs.text.shown_value (given));
    endif
  endfor
  t = given.t(:)';
  n = numel (t);
  sizes = isequal (size (given.x), [n m.sizes.nx]) && isequal (size (given.v), [n m.sizes.nv]);
  fine = n > 1 && all (diff (t) >= 0) && t(end) > t(1) && sizes ...
         && all (isfinite ([given.x(:); given.v(:)]));
  if (! fine)
    error (["%s: option guess: expected rising times, a row of %d states and of %d inputs for " ...
            "each, found %s, %s and %s"], who, m.sizes.nx, m.sizes.nv, ...
                gs.text.shown_value (given.t), ...
           gs.text.shown_value (given.x), gs.text.shown_value (given.v));
  endif
  g.T = t(end) - t(1);
  last = [diff(t) > 0, true];   # of equal times
  g.t = (t(last) - t(1)) / (t(end) - t(1));
  g.x = given.x(last,:)';
  g.v = given.v(last,:)';
endfunction
