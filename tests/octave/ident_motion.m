## d = ident_motion (M, NT, PHASE): a motion of the scene ident_arm at NT times and its exact
## efforts; PHASE: another one

function d = ident_motion (m, nt, phase)
  t = linspace (0, 4, nt)';
  w = [1.3 2.9; 1.7 3.7] * pi / 2;
  [d.t, d.q, d.u, d.ud] = deal (t, zeros (nt, 2), zeros (nt, 2), zeros (nt, 2));
  for j = 1:2
    for k = 1:2
      a = w(j,k) * t + k + phase;
      d.q(:,j) += sin (a) / k;
      d.u(:,j) += w(j,k) * cos (a) / k;
      d.ud(:,j) -= w(j,k) ^ 2 * sin (a) / k;
    end
  end
  for i = 1:nt
    d.tau(i,:) = m.inv (0, d.q(i,:)', d.u(i,:)', d.ud(i,:)', [0; 0]);
  end
end
