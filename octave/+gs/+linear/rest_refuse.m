## gs.linear.rest_refuse (p, z)
## The error of gsmbp_trim where no rest was found: Z is the best of it.

function rest_refuse (p, z)
  [w, beside] = gs.linear.rest_worst (p, z);
  f = gs.linear.rest_equations (p, z);
  [text, unit] = gs.text.rest_names (p);
  [~, order] = sort (beside, "descend");
  order = order(beside(order) > 1)(1:min (end, 4));
  left = cell (1, numel (order));
  for k = 1:numel (order)
    left{k} = sprintf ("%s = %g %s", text{order(k)}, f(order(k)), unit{order(k)});
  endfor
  help = helpers (p, z);
  advice = "try another guess, or let inputs be free";
  if (! isempty (help))
    advice = ["these inputs act on it: " strjoin(help, ", ") " (option \"free\")"];
  endif
  [x, v] = gs.linear.rest_state (p, z);
  what = {"equilibrium", "steady motion"}{1 + ! isempty(p.steady)};
  error ("%s: %s: no %s found near the guess; what does not vanish: %s%s; %s", p.who,
         p.m.name, what, strjoin (left, ", "), gs.start.outside_range (p.m, p.t, x, v), advice);
endfunction

## inputs that act on what the states cannot take away
function list = helpers (p, z)
  list = {};
  [x, v] = gs.linear.rest_state (p, z);
  d = p.m.sizes;
  [f, J] = gs.linear.rest_equations (p, z);
  row = max (abs (J) * p.size, p.usual);
  K = J .* p.size' ./ row;
  g = f ./ row;
  [~, B, ~, ~, ~] = p.m.jac (p.t, x, v);
  B = [B(p.rows,:); zeros(rows (J) - numel (p.rows), d.nv)] ./ row;
  if (! all (isfinite ([K(:); g; B(:)])))
    return;
  endif
  if (! isempty (K))
    g -= K * (pinv (K, 1e-10 * max (norm (K), realmin)) * g);
  endif
  for k = setdiff (1:d.nv, [p.inputs(:)', p.m.events(:).input])   # modes are no inputs
    if (norm (g) > 0 && abs (g' * B(:,k)) > 1e-6 * norm (g) * norm (B(:,k)))
      list{end+1} = p.m.inputs{k};
    endif
  endfor
endfunction
