## Points and frames against 30-digit references (tests/data/points_...): place, axes, Jacobian and
## (dJ/dt) u in the axes of ground and of the frame, velocity, acceleration. Error: the largest
## difference of an array over its largest entry; of dJb u, which is 0 for a frame that its Jacobian
## does not turn against, over the largest of dJ u and of what is subtracted.

function test_points ()
  against_reference ("points_puma", "points_puma560");
  against_reference ("points_scara", "points_scara");
  operations (gsmbp_fixture ("points_puma"));
  in_one_call (gsmbp_fixture ("points_puma"));
end

## PNJ and PNR are PNT and JPT, in fewer operations
function in_one_call (m)
  q = linspace (-2, 3, m.sizes.nq)';
  [P, R] = m.pnt (0, q);
  u = linspace (1, -2, m.sizes.nu)';
  [J, dJu] = m.jpt (0, q, u);
  [P1, R1, J1] = m.pnj (0, q);
  gsmbp_check ("points_puma: poses and Jacobians in one call", ...
               max (abs ([P1(:) - P(:); R1(:) - R(:); J1(:) - J(:)])), 1e-15);
  [P1, R1, J1, d1] = m.pnr (0, q, u);
  gsmbp_check ("points_puma: with rates", ...
               max (abs ([P1(:) - P(:); R1(:) - R(:); J1(:) - J(:); d1(:) - dJu(:)])), 1e-14);
  count = @(word) m.json.subroutines(strcmp (m.subroutines, word)).operations;
  both = [count("pnt"), count("jpt")];
  gsmbp_check ("points_puma: operations of PNJ, of those of both", ...
               (count ("pnj").mul + count ("pnj").add) / sum ([both.mul, both.add]), 0.5);
end

## multiplications and additions of J and (dJ/dt) u of the three frames, as measured
function operations (m)
  row = m.json.subroutines(strcmp (m.subroutines, "jpt"));
  n = row.operations;
  gsmbp_check ("points_puma: operations of JPT", n.mul + n.add, 287);
  gsmbp_check ("points_puma: calls of sine and cosine", n.trig, 10);
end

function against_reference (scene, data)
  m = gsmbp_fixture (scene);
  [~, ref] = gsmbp_case (data);
  fields = {"p", "R", "quaternion", "J", "dJu", "Jb", "dJbu", "V", "A"};
  worst = zeros (1, numel (fields));
  states = structs (ref.states);
  for s = states
    [q, u, ud] = deal (ne_numbers (s{1}.q), ne_numbers (s{1}.u), ne_numbers (s{1}.udot));
    for name = m.points'
      wanted = cellfun (@(f) ne_numbers (s{1}.frames.(name{1}).(f)), fields, ...
                        "UniformOutput", false);
      g = gsmbp_point (m, name{1}, 0, q, u, ud);
      b = gsmbp_point (m, name{1}, 0, q, u, "frame", name{1});
      found = {g.position, g.rotation, g.euler_parameters, g.jacobian, g.jacobian_rate, ...
               b.jacobian, b.jacobian_rate, [g.velocity; g.angular_velocity], ...
               [g.acceleration; g.angular_acceleration]};
      found{3} *= sign (found{3}' * wanted{3}(:));   # e and -e are one rotation
      scale = cellfun (@(b) max (abs (b(:))), wanted);
      scale(7) = max (scale([5, 7]));
      worst = max (worst, cellfun (@difference, found, wanted) ./ max (scale, 1e-3));
    end
  end
  for k = 1:numel (fields)
    gsmbp_check (sprintf ("%s: %s of %d frames, %d states", scene, fields{k}, ...
                          numel (m.points), numel (states)), worst(k), 1e-13);
  end
  batches (m, states);
end

function d = difference (a, b)
  d = max (abs (a(:) - b(:)));
end

function list = structs (list)
  if (! iscell (list))
    list = num2cell (list);
  end
  list = list(:)';
end

## the batches give what the handles for one state give
function batches (m, states)
  K = 24;
  q = 3 * randn (m.sizes.nq, K);
  u = randn (m.sizes.nu, K);
  [P, R] = m.pnt_v (zeros (1, K), q);
  [J, D] = m.jpt_v (zeros (1, K), q, u);
  worst = 0;
  for k = 1:K
    [p, r] = m.pnt (0, q(:,k));
    [j, d] = m.jpt (0, q(:,k), u(:,k));
    worst = max ([worst, cellfun(@(a, b) max (abs (a - b)(:)), {p, r, j, d}, ...
                                 {P(:,:,k), R(:,:,k), J(:,:,k), D(:,:,k)})]);
  end
  gsmbp_check ([m.name ": many states at once"], worst, 1e-13);
end
