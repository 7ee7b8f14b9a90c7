## gs.plan.check_continuous (who, m, pp, planned, times, static)
## An error of WHO where a derivative of the planned motion PP jumps, within TIMES, that the inverse
## of the devices needs continuous: all below the order of the command (STATIC: below 2).

function check_continuous (who, m, pp, planned, times, static)
  order = m.order;
  if (static)
    order = 2;
  endif
  inner = pp.breaks(2:end-1);
  inner = inner(inner > min (times) & inner < max (times));
  if (! any (strcmp (m.subroutines, "cmd")) || isempty (inner))
    return;
  endif
  n = numel (planned);
  before = reshape (gsmbp_evaluate (pp, inner, order - 1, -1), n, [], order);
  after = reshape (gsmbp_evaluate (pp, inner, order - 1, 1), n, [], order);
  within = pp.breaks(1:end-1) + diff (pp.breaks) .* [0.1; 0.3; 0.5; 0.7; 0.9];
  ends = reshape (gsmbp_evaluate (pp, sort (within(:)'), order - 1, 1), n, [], order);
  for k = 1:order
    sizes = max ([max(abs (ends(:,:,k)), [], 2), max(abs (before(:,:,k)), [], 2)], [], 2);
    jump = abs (after(:,:,k) - before(:,:,k));
    [row, at] = find (jump > 1e-9 * sizes + 1e-12 * max (sizes), 1);
    if (! isempty (row))
      refuse (who, m, planned(row), k - 1, inner(at), jump(row,at), order);
    endif
  endfor
endfunction

function refuse (who, m, q, k, t, jump, order)
  words = {"position", "speed", "acceleration", "jerk"};
  word = sprintf ("derivative %d", k);
  if (k < 4)
    word = words{k+1};
  endif
  hint = "";
  if (k > 1)
    hint = "; take a smoother plan, or option quasistatic";
  endif
  error ("gsmbp:smooth", ...
         ["%s: %s: the %s of %s jumps by %.4g at t = %.9g s: expected a motion with %d " ...
          "continuous derivatives, which the inverse of %s needs%s"], ...
         who, m.name, word, m.coordinates{q}, jump, t, order - 1, needing (m, q), hint);
endfunction

## devices whose inverse needs rates, those on the coordinate Q first
function text = needing (m, q)
  text = "the devices";
  if (! isfield (m.json, "devices") || isempty (m.json.devices))
    return;
  endif
  list = m.json.devices;
  if (! iscell (list))
    list = num2cell (list);
  endif
  need = cellfun (@(a) a.order > 0, list(:)');
  own = cellfun (@(a) any (a.drives(:) == q), list(:)');
  which = list(need & own);
  if (isempty (which))
    which = list(need);
  endif
  if (isempty (which))
    which = list(own);
  endif
  if (! isempty (which))
    text = strjoin (cellfun (@(a) sprintf ("%s (%s)", a.name, a.entry), which(:)', ...
        "UniformOutput", ...
                             false), ", ");
  endif
endfunction
