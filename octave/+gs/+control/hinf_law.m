## c = gs.control.hinf_law (who, p, o)
## The controller that is least in the norm of [W1 S; W2 K S; W3 T], by mixsyn of the control
## package on balanced states; with a period by Tustin's rule from the continuous one.

function c = hinf_law (who, p, o)
  if (! isempty (o.integral))
    error (["%s: option integral: expected a weight W1 that is large at low frequencies " ...
            "instead (hinf)"], who);
  endif
  w = o.weights;
  if (! (iscell (w) && numel (w) == 3) || all (cellfun (@isempty, w)))
    error (["%s: option weights: expected {W1, W2, W3}, of which one at least is not []; " ...
            "found %s"], who, gs.text.shown_value (w));
  endif
  [S, ~] = balance (p.A);
  G = ss (S \ p.A * S, S \ p.B, p.C * S, 0);
  try
    [K, ~, reached] = mixsyn (G, w{:});
  catch err
    error (["%s: no controller was found: %s; expected weights that are stable, W2 not 0 at " ...
            "high frequencies, no pole of the plant on the imaginary axis"], who, ...
           strtrim (strrep (err.message, "\n", " ")));
  end_try_catch
  if (isstruct (reached))
    reached = reached.gamma;
  endif
  if (p.h > 0)
    K = c2d (K, p.h, "tustin");
  endif
  [A, B, C, D] = ssdata (K);
  take = eye (rows (p.C))(:,p.followed);   # e = r - y
  c = struct ("A", A, "B", [-B, B * take], "C", C, "D", [-D, D * take], ...
              "G", zeros (rows (A), columns (p.B)), "K", [], "L", [], "gamma", reached);
  c.states = p.plant.stname;
endfunction
