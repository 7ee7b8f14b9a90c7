## r = speed_ratio (times, a, b, word): time of A over time of B, each {who, mode}: median of the
## ratios within the rounds; NaN where one is missing.

function r = speed_ratio (times, a, b, word)
  x = speed_pick (times, a{:}, word);
  y = speed_pick (times, b{:}, word);
  r = NaN;
  if (! isempty (x) && ! isempty (y))
    r = median (x(1).ns ./ y(1).ns);
  end
end
