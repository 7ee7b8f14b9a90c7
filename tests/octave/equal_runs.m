## same = equal_runs (A, I, B, K): whether runs I of the ensemble A are runs K of B, bit for bit

function same = equal_runs (a, i, b, k)
  same = isequaln (a.x(:,:,i), b.x(:,:,k)) && isequaln (a.v(:,:,i), b.v(:,:,k)) ...
           && isequaln (a.y(:,:,i), b.y(:,:,k)) && isequal (a.calls(i), b.calls(k)) ...
           && isequal (a.ok(i), b.ok(k)) && isequaln (a.reached(i), b.reached(k));
end
