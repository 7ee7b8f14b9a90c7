## [names, scaled, found] = gsmbp__residuals (m, t, x)
## How far the state X of the model M at the time T [s] is from its constraints: a
## row for each set of Euler parameters (its length less one), each constraint on
## positions (phi) and the rate of each constraint (H*u + phit).  FOUND: in the
## unit of the row; SCALED: beside what the usual sizes of the states (m.nominal)
## make of it, so that it is a relative change of the state.  Constraints are not
## looked at where CON was not emitted.

function [names, scaled, found] = gsmbp__residuals (m, t, x)
  d = m.sizes;
  names = cell (0, 1);
  scaled = found = zeros (0, 1);
  for set = m.orientation'
    names{end+1,1} = sprintf ("length of (%s) - 1", strjoin (m.coordinates(set)', ", "));
    scaled(end+1,1) = found(end+1,1) = norm (x(set)) - 1;
    x(set) /= norm (x(set));   # the other rows as they are with that mended
  endfor
  if (d.nlam == 0 || ! any (strcmp (m.subroutines, "con")))
    return;
  endif
  u = x(d.nq + (1:d.nu));
  [phi, phit, H, ~, ~] = m.con (t, x(1:d.nq), u);
  rate = H * u + phit;
  usual = m.nominal(d.nq + (1:d.nu));
  size_ = sized (sqrt ((H .^ 2) * (usual .^ 2)));
  fast = max ([size_, abs(H) * abs(u), abs(phit)], [], 2);
  have_phi = setdiff ((1:d.nlam)', m.speed_rows);
  label = gsmbp__row_names (m);
  names = [names; label(have_phi); strcat({"rate of "}, label)];
  found = [found; phi(have_phi); rate];
  scaled = [scaled; phi(have_phi) ./ size_(have_phi); rate ./ fast];
endfunction

## a row that vanishes here (at a singular position) counts by the others
function s = sized (s)
  s = max (s, 1e-3 * max (s));
  s(! (s > 0)) = 1;
endfunction
