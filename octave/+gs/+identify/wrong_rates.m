## list = gs.identify.wrong_rates (m, data)
## Sentences of the columns of measured DATA that are not the rates that they should be: u of q, ud
## of u.  Integrals are compared: they enlarge no noise.

function list = wrong_rates (m, data)
  list = {};
  for pair = {"q", "u"; "u", "ud"}'
    for j = 1:m.sizes.nu
      [x, s] = in_parts (data.t(:), data.(pair{1})(:,j), data.(pair{2})(:,j));
      off = size_of (x - s);
      most = max (size_of (x), size_of (s));
      noise = size_of (diff (data.(pair{1})(:,j), 2)) / sqrt (6);
      if (off < 0.05 * most || off < 5 * noise)
        continue;
      endif
      k = (s' * x) / (s' * s + realmin);
      told = "";
      if (size_of (x - k * s) < 0.2 * off)
        told = sprintf ("; times %.3g it fits", k);
      endif
      of = {"", "u."}{1 + strcmp(pair{1}, "u")};
      list{end+1} = sprintf (["%s.%s is not the rate of %s%s: its integral misses it by an rms " ...
                              "of %.3g, which is %.2g of the motion%s"], pair{2}, ...
                             m.coordinates{j}, of, m.coordinates{j}, off, off / most, told);
    endfor
  endfor
endfunction

## X and the integral of its rate, without their means, in each part without a gap of times
function [x, s] = in_parts (t, x, rate)
  s = zeros (size (x));
  h = diff (t);
  if (isempty (h))
    x = s;
    return;
  endif
  ends = [0; find(h <= 0 | h > 5 * median (h)); numel(t)];
  for k = 1:numel (ends) - 1
    at = ends(k)+1:ends(k+1);
    s(at) = 0;
    if (numel (at) > 1)
      s(at) = cumtrapz (t(at), rate(at));
    endif
    x(at) -= sum (x(at)) / numel (at);
    s(at) -= sum (s(at)) / numel (at);
  endfor
endfunction

function r = size_of (x)
  r = sqrt (sumsq (x) / numel (x));
endfunction
