## D = ne_difference (F, H): derivative of F (values of any size) by its scalar argument at 0, by
## differences of eighth order with steps H, 2 H, 3 H, 4 H.

function d = ne_difference (f, h)
  c = [4/5, -1/5, 4/105, -1/280] / h;
  d = 0;
  for k = 1:4
    d += c(k) * (f (k * h) - f (-k * h));
  end
end
