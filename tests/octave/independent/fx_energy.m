## [T, V] = fx_energy (TREE, Q, QD): kinetic and potential energy of a tree of rigid and flexible
## links, written without GSMBP: the field of every point of a beam, summed over Gauss points; rates
## of places by complex steps.
##
## TREE.bodies: struct array, parents first, with
##   parent  0 is ground             at  place in the parent: [x; y; z], or in the section of a beam
##   section                         that section of a parent that is a beam (fx_sections)
##   turn    axis and number of the coordinate {[x; y; z], k}, {} of a fixed joint
##   mass, centre, inertia           of a rigid link
##   beam                            of a flexible one: fx_beam
## TREE.gravity. The model second is cut at degree 2 in the coordinates of the modes and their
## rates, found from the values at seven sizes of these.

function [T, V] = fx_energy (tree, q, qd)
  [T, V] = deal (0);
  h = 1e-30;
  now = poses (tree, q);
  moved = poses (tree, q + 1i * h * qd);
  for k = 1:numel (tree.bodies)
    b = tree.bodies(k);
    R = now{k}.R;
    v = R' * imag (moved{k}.p) / h;
    W = R' * imag (moved{k}.R) / h;
    w = [W(3, 2); W(1, 3); W(2, 1)];
    g = R' * tree.gravity;
    if (isempty (b.beam))
      c = v + cross (w, b.centre);
      T += b.mass * (c' * c) / 2 + w' * b.inertia * w / 2;
      V -= b.mass * (tree.gravity' * now{k}.p + g' * b.centre);
    else
      n = [b.beam.modes.k];
      T += kinetic (b.beam, v, w, q(n), qd(n));
      r = fx_field (b.beam, q(n), b.beam.gauss);
      V -= b.beam.L ...
           * sum (b.beam.rho .* b.beam.gauss.weight .* (g' * r.place + tree.gravity' * now{k}.p));
      V += sum ([b.beam.modes.stiffness] .* q(n)' .^ 2) / 2;
    end
  end
end

function T = kinetic (beam, v, w, q, qd)
  if (! strcmp (beam.model, "second"))
    T = kinetic_whole (beam, v, w, q, qd);
    return;
  end
  s = (-3:3)';
  t = arrayfun (@(s) kinetic_whole (beam, v, w, s * q, s * qd), s);
  c = (s .^ (0:6)) \ t;      # degree 6 at most: h^2 rates
  T = sum (c(1:3));
end

function T = kinetic_whole (beam, v, w, q, qd)
  h = 1e-30;
  weight = beam.gauss.weight;
  r = fx_field (beam, q, beam.gauss);
  d = fx_field (beam, q + 1i * h * qd, beam.gauss);
  u = v + cross (repmat (w, 1, columns (r.place)), r.place) + imag (d.place) / h;
  turned = w + imag (d.angles) / h;
  T = beam.L * sum (beam.rho .* weight .* sum (u .^ 2)) / 2 ...
      + beam.L * sum (weight .* sum (turned .* beam.J .* turned)) / 2;
end

## [p, R] of every body
function now = poses (tree, q)
  for k = 1:numel (tree.bodies)
    b = tree.bodies(k);
    [p, R] = deal (zeros (3, 1), eye (3));
    if (b.parent > 0)
      [p, R] = deal (now{b.parent}.p, now{b.parent}.R);
      m = tree.bodies(b.parent).beam;
      if (! isempty (m))
        r = fx_field (m, q([m.modes.k]), b.section);
        p += R * r.place;
        R = R * ne_turn ([0; 0; 1], r.angles(3)) * ne_turn ([0; 1; 0], r.angles(2)) ...
            * ne_turn ([1; 0; 0], r.angles(1));
      end
    end
    p += R * b.at;
    if (! isempty (b.turn))
      R = R * ne_turn (b.turn{1} / norm (b.turn{1}), q(b.turn{2}));
    end
    now{k} = struct ("p", p, "R", R);
  end
end
