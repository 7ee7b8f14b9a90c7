## text = speed_examples (root): a table of the derivation of examples, everything that they can
## have.

function text = speed_examples (root)
  rows = {};
  for name = {"puma560", "slider_crank"}
    cpu = min (arrayfun (@(k) gsmbp_derive (fullfile (root, "examples", name{1}, ...
                             [name{1} ".mac"])), 1:3));
    rows{end+1} = {name{1}, sprintf("%.2f", cpu)};
  end
  text = speed_table ("Derivation of the examples", ...
                      ["Processor seconds, best of three, Maxima's start included; the aim is " ...
                       "below 3."], {"example", "derive s"}, rows);
end
