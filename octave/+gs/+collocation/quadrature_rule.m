## rule = gs.collocation.quadrature_rule (name)
## The collocation on one interval of length 1: "lobatto", stages at 0, 1/2, 1 (Hermite-Simpson,
## order 4), or "radau", Radau IIA with three stages (order 5).  C: the stages; A: their weights, a
## row for each state that an equation defines; B: the weights of the interval; OWN: the stages that
## do not belong to the interval before; ORDER.
## Source: Hairer and Wanner, Solving Ordinary Differential Equations II, tables IV.5.6, IV.5.7.

function rule = quadrature_rule (name)
  if (strcmp (name, "lobatto"))
    rule = struct ("c", [0 1/2 1], "A", [5/24 1/3 -1/24; 1/6 2/3 1/6], "order", 4);
  else
    s = sqrt (6);
    rule = struct ("c", [(4-s)/10, (4+s)/10, 1], "order", 5, ...
                   "A", [(88-7*s)/360, (296-169*s)/1800, (-2+3*s)/225
                         (296+169*s)/1800, (88+7*s)/360, (-2-3*s)/225
                         (16-s)/36, (16+s)/36, 1/9]);
  endif
  rule.name = name;
  rule.own = find (rule.c > 0);
  rule.b = rule.A(end,:);
endfunction
