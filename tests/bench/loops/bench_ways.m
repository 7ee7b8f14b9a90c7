## [words, colors] = bench_ways (): the ways to integrate a loop, as gsmbp_simulate names them, and
## the colours of their curves.

function [words, colors] = bench_ways ()
  words = {"projection", "baumgarte", "partitioning", "nullspace", "svd", "kane"};
  colors = {"#00459a", "#cc3318", "#1a7f37", "#80339a", "#d98c00", "#3399b3"};
end
