## r = gsmbp__derivatives (m, r, carried, S)
## The result R of a run of M with the derivatives that it carried (gsmbp__carried): structs dx and
## dy by the names of what they are by, a row for each time.  S: the columns at all times.

function r = gsmbp__derivatives (m, r, carried, S)
  d = m.sizes;
  n = numel (r.t);
  S = reshape (S, d.nx, numel (carried.names), n);
  Y = outputs (m, r, carried, S);
  r.dx = r.dy = struct ();
  for k = 1:numel (carried.names)
    r.dx.(carried.names{k}) = reshape (S(:,k,:), d.nx, n)';
    r.dy.(carried.names{k}) = reshape (Y(:,k,:), d.ny, n)';
  endfor
endfunction

## dy = C*S + what the parameters do by themselves; NaN where that is not emitted
function Y = outputs (m, r, carried, S)
  d = m.sizes;
  Y = NaN (d.ny, columns (S), numel (r.t));
  if (d.ny == 0 || ! all (ismember ({"oup", "jac"}, m.subroutines)))
    return;
  endif
  for i = 1:numel (r.t)
    x = r.x(i,:)';
    v = r.v(i,:)';
    [~, ~, C] = m.jac (r.t(i), x, v);
    P = [zeros(d.ny, 1), m.oup(r.t(i), x, v)];
    Y(:,:,i) = C * S(:,:,i) + P(:,1+carried.columns);
  endfor
endfunction
