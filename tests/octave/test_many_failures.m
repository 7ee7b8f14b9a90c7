## Runs that fail, one of many as one alone: trial steps that cannot be made, reasons in the words
## of gsmbp_simulate.

function test_many_failures ()
  m = gsmbp_fixture ("many_failures");
  wall (m);
end

## a body comes back from a wall beyond which there is no force: trial steps end there, shorter ones
## do not, in lanes, too; it keeps its energy
function wall (m)
  n = 40;
  table = struct ("q", 10 .^ linspace (-5, -2, n), "edge", repmat (0.3, 1, n));
  energy = @(x) x(:,3) .^ 2 / 2 + 2 * table.q' ./ sqrt (0.3 - x(:,1));
  for rtol = [1e-4, 1e-6, 1e-8]
    for lanes = [false, true]
      e = gsmbp_ensemble (m, [0 0 1 0.1], [0 0.5 1 2], "parameters", table, "lanes", lanes, ...
                          "rtol", rtol, "atol", rtol);
      what = sprintf ("a wall, rtol = %g, %s", rtol, {"one by one", "in lanes"}{1 + lanes});
      gsmbp_check ([what ": all come to their end"], e.lanes == lanes && all (e.ok));
      gsmbp_check ([what ": back with the energy they had"], all (e.final(:,1) < 0) ...
                   && all (abs (energy (e.final) - energy (repmat ([0 0 1 0.1], n, 1))) ...
                           < 200 * rtol));
    end
  end
end
