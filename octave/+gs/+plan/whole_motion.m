## one = gs.plan.whole_motion (who, m, jet, planned, t, guess)
## Coordinates, speeds and accelerations of all of M at T, the planned ones as the JET says, whose
## first column holds their values and whose others their derivatives (0 where it has none).

function one = whole_motion (who, m, jet, planned, t, guess)
  powers = columns (jet) - 1:-1:0;
  pp = mkpp ([t, t + 1], fliplr (jet) ./ factorial (powers), rows (jet));
  one = gs.plan.along_plan (who, m, pp, planned, t, 1, guess);
endfunction
