## gsmbp__no_beginning (who, m, t, x, why)
## The error of a start X at T where the constraints of M lose rank: WHY the run does not begin
## there (ISTAT(6) of GSSIM).

function gsmbp__no_beginning (who, m, t, x, why)
  d = m.sizes;
  [~, ~, H] = m.con (t, x(1:d.nq), x(d.nq + (1:d.nu)));
  [U, S] = svd (H);
  s = [diag(S); zeros(d.nlam - min (size (S)), 1)];
  lost = s <= 1e-3 * max (s);
  rows = any (abs (U(:,lost)) > 0.1, 2);
  reasons = {"only method \"dp853\" begins there", ...
             "at rest it may go on in more than one way", ...
             "no motion with these speeds was found that leaves it"};
  error ("gsmbp:start",
         ["%s: %s: expected a start where the constraints are independent; at t = %.9g s they " ...
          "lose rank, found in rows %s: %s; start beside that position"],
         who, m.name, t, strjoin (gsmbp__row_names (m)(rows)', ", "), reasons{why});
endfunction
