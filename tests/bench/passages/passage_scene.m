## s = passage_scene (NAME, M): a motion without forces through ten positions where the constraints
## lose rank, and an equally long one of the same model M without such positions.  NAME:
## "parallelogram" (M: four_bar, or hand_fourbar of the tests), "parallelograms" (M:
## tests/scenes/parallelograms3 or its like of ten), "slider-crank" (M: hand_crank).
## s: name, m, x0, smooth, xs (models and starts), last [s].

function s = passage_scene (name, m)
  w = 6;   # rad/s
  m = gsmbp_set (m, "g", 0);
  d = m.sizes;
  last = 10 * pi / w;
  switch (name)
    case "parallelogram"
      absolute = any (strcmp (m.coordinates, "q1"));
      lengths = {"l1", "l2", "l3", "l4"};
      if (! absolute)
        lengths = {"la", "lb", "lc", "ld"};
      end
      [smooth, m] = deal (sized (m, lengths, [0.2, 0.25, 0.25, 0.1]), ...
                          sized (m, lengths, [0.1, 0.25, 0.1, 0.25]));
      x0 = [1; -(! absolute); 1; w; -w * (! absolute); w];
      guess = [1; 0.5 - (! absolute); 1; w; 0; w];
    case "parallelograms"
      smooth = sized (m, {"lr", "lb", "ld"}, [0.25, 0.2, 0.1]);
      crank = strncmp (m.coordinates, "q", 1)(:);
      x0 = [ones(d.nq, 1); w * ones(d.nu, 1)] .* (2 * [crank; crank] - 1);
      guess = x0;
    case "slider-crank"
      smooth = sized (m, {"l1", "l2"}, [0.3, 0.6]);
      m = sized (m, {"l1", "l2"}, [0.3, 0.3]);
      q = 0.3;
      x0 = [q; -q; 0.6*cos(q); w; -w; -0.6*w*sin(q)];
      guess = [q; -q/2; 0.8; w; 0; 0];
      last *= 1.65;
  end
  xs = gsmbp_assemble (smooth, guess, "hold", m.coordinates{1});
  s = struct ("name", name, "m", m, "x0", x0, "smooth", smooth, "xs", xs, "last", last);
end

function m = sized (m, names, values)
  m = gsmbp_set (m, [names; num2cell(values)]{:});
end
