## p = gs.control.linear_plant (who, m, e, o)
## The linear plant of a controller: A, B, C of what is measured and driven, names and values at the
## trim E of the model M, or those of M where it is an ss object.  O: options of gsmbp_control.
## p.rolling: what an error says of coordinates that rolling leaves beside the speeds, or "".

function p = linear_plant (who, m, e, o)
  if (isa (m, "lti"))
    sys = ss (m);
    if (isdt (sys))
      error ("%s: expected a continuous model; give the period as an option", who);
    endif
    [inputs, outputs, states] = deal (named (sys.inname, "u"), named (sys.outname, "y"), ...
                                      named (sys.stname, "x"));
    [y, v, held] = deal (zeros (numel (outputs), 1), zeros (numel (inputs), 1), []);
    x0 = zeros (numel (states), 1);
    rolling = "";
  else
    gs.given.check_model (who, m);
    if (! (isstruct (e) && all (isfield (e, {"x", "v"}))))
      error (["%s: argument e: expected the result of gsmbp_trim (a struct with x and v), " ...
              "found %s"], who, gs.text.shown_value (e));
    endif
    [sys, ~, states] = gsmbp_linear (m, 0, e.x, e.v, "reduced", o.reduced, "drop", o.drop);
    x0 = e.x(states)(:);
    rolling = told_of_rolling (m, states, sys.a);
    [inputs, outputs, states] = deal (m.inputs, sys.outname, m.states(states));
    v = double (e.v(:));
    held = vertcat (m.controllers.outputs);
    y = e.x(nonzeros (gs.given.places_of (outputs, m.states)));
    if (m.sizes.ny > 0)
      y = m.out (0, e.x, v)(gs.given.places_of (outputs, m.outputs));
    endif
  endif
  k = chosen (who, "measured", o.measured, outputs, 1:numel (outputs));
  j = chosen (who, "inputs", o.inputs, inputs, setdiff (1:numel (inputs), held));
  if (isempty (j))
    error ("%s: argument m: expected a model with inputs; found none", who);
  endif
  if (isempty (k))
    error ("%s: argument m: expected a model with outputs; found none%s", who,
           {"", ", those of the scene follow what option drop takes out"}{1 + ! isempty(o.drop)});
  endif
  gs.given.need_derivatives ([who, ": plant"], [sys.c(k,:), sys.d(k,j)], ...
                             strcat ({"output "}, outputs(k)(:)), [states(:); inputs(j)(:)]);
  direct = find (any (sys.d(k,j), 2), 1);
  if (! isempty (direct))
    error ("%s: the output %s follows the inputs directly, without a state between", who, ...
           outputs{k(direct)});
  endif
  p = struct ("A", sys.a, "B", sys.b(:,j), "C", sys.c(k,:), "measured", {outputs(k)(:)}, ...
              "driven", {inputs(j)(:)}, "states", {states(:)}, "y0", y(k)(:), "u0", v(j)(:), ...
              "x0", x0, "rolling", rolling);
  both = [gs.given.asked_names(o.integral); gs.given.asked_names(o.track)];
  if (! isempty (both) && ! isempty (o.integral) && ! isempty (o.track))
    error ("%s: options integral and track: expected one of them, found both", who);
  endif
  p.followed = [];
  if (! isempty (both))
    p.followed = chosen (who, {"integral", "track"}{1 + isempty(o.integral)}, both, p.measured, []);
  endif
  p.references = strcat (p.measured(p.followed), "_ref");
  p.r0 = p.y0(p.followed);
endfunction

## constraints of speeds alone leave more independent coordinates than speeds; those are listed on
## which no rate depends
function text = told_of_rolling (m, states, A)
  q = find (states <= m.sizes.nq);
  u = nnz (states > m.sizes.nq & states <= m.sizes.nq + m.sizes.nu);
  text = "";
  if (numel (q) > u)
    alone = q(all (abs (A(:,q)) <= 1e-12 * max ([abs(A)(:); realmin]), 1));
    names = [m.states(states(alone)); {"others"}(isempty (alone))];
    text = sprintf (["; constraints of speeds alone, as rolling, leave %d coordinates beside " ...
                     "%d speeds; remedy: option drop with those that need no control (no rate " ...
                     "depends on %s)"], numel (q), u, strjoin (names(:)', ", "));
  endif
endfunction

function names = named (names, letter)
  for k = find (cellfun (@isempty, names(:)'))
    names{k} = sprintf ("%s%d", letter, k);
  endfor
endfunction

function k = chosen (who, option, names, known, default)
  names = gs.given.asked_names (names);
  if (isempty (names))
    k = default;
    return;
  endif
  k = vec (gs.given.places_of (names, known), 2);
  if (! all (k))
    error ("%s: option %s: unknown name %s", who, option,
           gs.text.nearest_word (names{find (! k, 1)}, known));
  endif
endfunction
