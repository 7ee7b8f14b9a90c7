## e = state_gap (a, b): the largest difference of a state at any row of two runs, beside the
## largest value that it has in B, 1 at least

function e = state_gap (a, b)
  e = max (max (abs (a.x - b.x) ./ max (1, max (abs (b.x)))));
end
