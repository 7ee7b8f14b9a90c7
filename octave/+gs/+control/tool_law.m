## c = gs.control.tool_law (who, m, o, c)
## Springs, dampers and references of a tool: the point or frame of option "frame".

function c = tool_law (who, m, o, c)
  if (! all (ismember ({"pnt", "jpt"}, m.subroutines)))
    error (["%s: %s was emitted without PNT and JPT: a tool is a point or frame of the scene; " ...
            "requests points, point_jacobians: %s"], who, m.name, ...
           gs.text.why_left_out (m, "points"));
  endif
  if (isempty (o.frame) && numel (m.points) == 1)
    o.frame = m.points{1};
  endif
  gs.given.check_kind (who, "option frame", o.frame, m.points(:)');
  c.tool = find (strcmp (m.points, o.frame));
  c.tools = numel (m.points);
  c.axes = o.axes;
  c.K = six (who, "K", o.K);
  c.D = six (who, "D", o.D);
  n = numel (c.through.independent);
  c.damping = o.damping(:);
  if (isscalar (c.damping))
    c.damping = repmat (c.damping, n, 1);
  endif
  if (numel (c.damping) != n || ! all (c.damping >= 0 & isfinite (c.damping)))
    error ("%s: option damping: expected 1 or %d numbers that are not negative, found %s", who, ...
           n, gs.text.shown_value (o.damping));
  endif
  names = strcat (o.frame, "_", {"x"; "y"; "z"; "rx"; "ry"; "rz"});
  c.references = [strcat(names, "_ref"); strcat(names, "_d_ref")];
  c.units = {"m"; "m"; "m"; "rad"; "rad"; "rad"; "m/s"; "m/s"; "m/s"; "rad/s"; "rad/s"; "rad/s"};
  p = gsmbp_point (m, o.frame, 0, c.through.guess);
  c.r0 = [p.position; gs.plan.rotation_vector(p.rotation); zeros(6, 1)];
endfunction

## one number for shifts, three for shifts, six, or a matrix of three or six; positive semidefinite
function K = six (who, name, given)
  K = double (given);
  if (isscalar (K))
    K = [K, K, K];
  endif
  if (isvector (K))
    K = diag (K);
  endif
  if (! (issquare (K) && any (rows (K) == [3, 6]) && all (isfinite (K(:)))))
    error (["%s: option %s: expected 1, 3 or 6 numbers or a matrix 3 x 3 or 6 x 6 (shifts, " ...
            "then turns), found %d x %d"], who, name, size (given));
  endif
  if (norm (K - K', 1) > 1e-12 * norm (K, 1) || min (eig ((K + K') / 2)) < -1e-12 * norm (K, 1))
    error (["%s: option %s: expected a symmetric matrix without negative eigenvalues, found " ...
            "eigenvalues down to %g, %g off symmetry"], who, name, min (eig ((K + K') / 2)), ...
           norm (K - K', 1));
  endif
  K = blkdiag (K, zeros (6 - rows (K)));
endfunction
