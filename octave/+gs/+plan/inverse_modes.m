## r = gs.plan.inverse_modes (who, m, pp, times, o)
## The result of gsmbp_inverse for a motion PP of the coordinates that INQ is given: the modal
## coordinates of flexible links, and what follows through loops, in quasi-static balance. O:
## options of gsmbp_inverse, checked.

function r = inverse_modes (who, m, pp, times, o)
  d = m.sizes;
  given = m.json.given(:);
  nt = numel (times);
  r = struct ("t", times(:), "tau", zeros (nt, d.nu), "lambda", zeros (nt, d.nlam), ...
              "unique", m.unique.multipliers, "v", zeros (nt, 0), "x", NaN (nt, d.nx), ...
              "margins", zeros (nt, 0), "violations", gs.plan.limit_violations (m, struct ("v", ...
                  []), {}, []));
  qj = zeros (d.nu, 3, nt);
  guess = o.guess;
  for i = 1:nt
    one = zeros (d.nu, 3);
    one(:,1) = guess;
    one(given,:) = reshape (gsmbp_evaluate (pp, times(i), 2, o.side), numel (given), 3);
    parts = cell (1, 5 + (d.nlam > 0));
    [parts{:}] = m.inq (times(i), one(:,1), one(:,2), one(:,3), o.input);
    if (parts{end} != 0)
      error ("%s: %s: no quasi-static balance of the modes at t = %.9g s (%s)", who, m.name, ...
             times(i), gs.text.info_meaning (m, "inq", parts{end}));
    endif
    qj(:,:,i) = [parts{1:3}];
    guess = parts{1};
    r.tau(i,:) = parts{4};
    if (d.nlam > 0)
      r.lambda(i,:) = parts{5};
    endif
  endfor
  r.q = reshape (qj(:,1,:), d.nu, nt)';
  r.u = reshape (qj(:,2,:), d.nu, nt)';
  r.ud = reshape (qj(:,3,:), d.nu, nt)';
  r.qj = qj;
  r.x(:,1:2*d.nu) = [r.q, r.u];
  r.y = NaN (nt, d.ny);
  r = gs.model.named_results (m, r);
endfunction
