## w = gs.collocation.input_width (v)
## Return the width of each input, a row of V for each: its range and a thousandth of its largest
## magnitude; 1 (SI unit) for an input that stays at zero, which has no magnitude of its own.

function w = input_width (v)
  w = max (v, [], 2) - min (v, [], 2) + 1e-3 * max (abs (v), [], 2);
  w(w < 1e-6) = 1;
endfunction
