## B = fx_beam (L, RHO, J, MODEL, ROWS): a beam for fx_energy: length, mass by length, inertia of
## its sections by length (3 x 1), each a number or a function of xi (row), model
## second, full or linear; ROWS of a cell array, one for each mode: kind (y, z, twist, stretch),
## ends and number of its shape (fx_shape) or a function of xi
## that gives [phi, slope] and 0, number of its coordinate, stiffness.

function b = fx_beam (L, rho, J, model, rows)
  for k = 1:size (rows, 1)
    shape = rows{k, 2};
    if (ischar (shape))
      shape = @(xi) fx_shape (rows{k, 2}, rows{k, 3}, xi);
    end
    modes(k) = struct ("kind", rows{k, 1}, "shape", shape, "k", rows{k, 4}, ...
                       "stiffness", rows{k, 5});
  end
  b = struct ("L", L, "model", model, "modes", modes, "gauss", []);
  [x, w] = fx_gauss (20);
  b.gauss = fx_sections (b, x);
  b.gauss.weight = w;
  [b.rho, b.J] = deal (along (rho, x), along (J, x));
end

function v = along (f, x)
  if (is_function_handle (f))
    v = f(x);
  else
    v = repmat (f, 1, numel (x));
  end
end
