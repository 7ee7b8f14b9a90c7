## d = gs.identify.sound_data (who, m, d, without)
## The data of WHO as gsmbp_measured gives them, or an error; efforts of the coordinates WITHOUT
## need not be there.

function d = sound_data (who, m, d, without)
  n = m.sizes.nu;
  if (! (isstruct (d) && isscalar (d) && all (isfield (d, {"t", "q", "u", "ud", "tau"}))))
    error (["%s: argument data: expected a struct of gsmbp_measured with the fields t, q, u, " ...
            "ud, tau, found %s"], who, gs.text.shown_value (d));
  endif
  nt = numel (d.t);
  if (isempty (d.tau) && all (ismember (m.coordinates, without)))
    d.tau = zeros (nt, n);
  endif
  for name = {"q", "u", "ud", "tau"}
    x = d.(name{1});
    if (strcmp (name{1}, "tau") && columns (x) == n)
      x(:,ismember (m.coordinates, without)) = 0;
    endif
    gs.identify.check_data (who, m, name{1}, x, nt);
    d.(name{1}) = double (x);
  endfor
  for name = {"other", "other_d"}
    if (! isfield (d, name{1}))
      d.(name{1}) = struct ();
    endif
  endfor
endfunction
