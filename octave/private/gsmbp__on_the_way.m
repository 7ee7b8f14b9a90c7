## p = gsmbp__on_the_way (p, names, table)
## The plan P of one of many runs (gsmbp__run_of_many) with room for the outputs of sampled devices
## that are on their way in any of them: periods and delays are those of the parameters NAMES, whose
## values are the rows of TABLE.

function p = gsmbp__on_the_way (p, names, table)
  if (isempty (p.m.controllers) || isempty (table))
    return;
  endif
  [~, which] = ismember (names, fieldnames (p.m.par)');
  most = p.m.module ("on the way", cellfun (@double, struct2cell (p.m.par)), which, table);
  p.arguments{11}.on_the_way = max (p.arguments{11}.on_the_way, most);
endfunction
