## text = gsmbp__no_beginning (m, t, last, why)
## That a run of M does not begin at T where the constraints lose rank in LAST.x (empty: not known),
## and WHY (ISTAT(6) of GSSIM).

function text = gsmbp__no_beginning (m, t, last, why)
  reasons = {"only method \"dp853\" begins there", ...
             "at rest it may go on in more than one way", ...
             "no motion with these speeds was found that leaves it"};
  text = sprintf (["expected a start where the constraints are independent; at t = %.9g s they " ...
                   "lose rank: %s; start beside that position"], t, reasons{why});
  if (! isempty (last))
    text = sprintf ("%s; found in rows %s", text, strjoin (rows_of (m, t, last.x)', ", "));
  endif
endfunction

function names = rows_of (m, t, x)
  d = m.sizes;
  [~, ~, H] = m.con (t, x(1:d.nq), x(d.nq + (1:d.nu)));
  [U, S] = svd (H);
  s = [diag(S); zeros(d.nlam - min (size (S)), 1)];
  lost = s <= 1e-3 * max (s);
  names = gsmbp__row_names (m)(any (abs (U(:,lost)) > 0.1, 2));
endfunction
