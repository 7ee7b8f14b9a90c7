## s = gs.drive.screw_support (who, given)
## Check {length, ends} of a screw: S has length [m] and the factors of its ends, euler (of Euler's
## load E*I/length^2) and whirl (of the critical speed sqrt (E*I/(rho*A))/length^2); [] where
## nothing is GIVEN. Source: Timoshenko and Gere, Theory of Elastic Stability, 1961 (columns);
## Blevins, Formulas for Natural Frequency and Mode Shape, 1979 (beams).

function s = screw_support (who, given)
  s = [];
  if (isempty (given))
    return;
  endif
  table = {"fixed-free", (pi / 2) ^ 2, 1.875104068711961
           "supported-supported", pi ^ 2, pi
           "fixed-supported", 4.493409457909064 ^ 2, 3.926602312047919
           "fixed-fixed", 4 * pi ^ 2, 4.730040744862704};
  if (! (iscell (given) && numel (given) == 2 && isnumeric (given{1}) && isscalar (given{1}) ...
           && given{1} > 0 && any (strcmp (given{2}, table(:,1)))))
    error (["%s: support: expected {length, ends} of a screw with a length above 0 m and ends " ...
            "one of %s; found %s"], who, strjoin (table(:,1)', ", "), gs.text.shown_value (given));
  endif
  row = table(strcmp (given{2}, table(:,1)),:);
  s = struct ("length", double (given{1}), "ends", row{1}, "euler", row{2}, "whirl", row{3} ^ 2);
endfunction
