## m = derived_model (NAME): derives the scene NAME.mac of the example, prints how long that took,
## and builds the model m.

function m = derived_model (name)
  [cpu, wall] = gsmbp_derive ([name ".mac"]);
  printf (["derivation: %.1f s of processor time, %.1f s by the clock, Maxima's start " ...
           "included\n"], cpu, wall);
  m = gsmbp_build (name);
endfunction
