## m = random_text (M): the text of the scene of a mechanism of random_scene, in m.text. Masses are
## parameters here and there.

function m = random_text (m)
  m.parameters = {};
  elements = {sprintf("gravity = %s", list (m.gravity))};
  for b = 1:numel (m.body)
    [elements{end + 1}, m] = link_text (m, b);
  end
  order = 1:numel (m.joint) + numel (m.loop);
  for j = order
    if (j <= numel (m.joint))
      elements{end + 1} = joint_text (m, m.joint(j), tree_options (m, m.joint(j)));
    else
      elements{end + 1} = joint_text (m, m.loop(j - numel (m.joint)), ...
                                      {", cut = true", ""}{1 + m.auto});
    end
  end
  elements = [elements, m.elements];
  for f = m.given
    elements{end + 1} = force_text (m, f);
  end
  for s = m.spring
    elements{end + 1} = spring_text (m, s, "spring(sp, %s, stiffness = %s, rest = %s)", ...
                                     {hundredths(s.stiffness), hundredths(s.rest)});
    if (s.damping)
      elements{end + 1} = spring_text (m, s, "damper(dp, %s, damping = %s)", ...
          {hundredths(s.damping)});
    end
  end
  if (! isempty (m.parameters))
    elements{end + 1} = sprintf ("parameters = [%s]", strjoin (m.parameters, ", "));
  end
  m.text = sprintf ("%s\nscene : apply(gsmbp_scene, [\"%s\",\n  %s])$\n", helpers (), m.name, ...
                    strjoin (elements, ",\n  "));
end

## Maxima: rotation of a quaternion of integers, points and vectors of the world in the axes of a
## link
function text = helpers ()
  text = ...
      ["turn(a, b, c, d) := matrix([a^2+b^2-c^2-d^2, 2*(b*c-a*d), 2*(b*d+a*c)], [2*(b*c+a*d), " ...
       "a^2-b^2+c^2-d^2, 2*(c*d-a*b)],\n" ...
          "  [2*(b*d-a*c), 2*(c*d+a*b), a^2-b^2-c^2+d^2]) / (a^2+b^2+c^2+d^2)$\n" ...
          "seen(R, x) := flatten(args(transpose(R) . transpose(matrix(x))))$\n"];
end

function text = list (x)
  text = ["[" strjoin(arrayfun (@hundredths, x(:)', "UniformOutput", false), ", ") "]"];
end

function text = integers (x)
  text = ["[" strjoin(arrayfun (@(y) sprintf ("%d", y), x(:)', "UniformOutput", false), ", ") "]"];
end

function text = turn (quaternion)
  text = sprintf ("turn(%d, %d, %d, %d)", quaternion);
end

function text = body_name (b)
  text = "ground";
  if (b)
    text = sprintf ("b%d", b);
  end
end

## a point of the world, or a direction, in the axes of link b
function text = point_text (m, b, x)
  text = sprintf ("seen(%s, %s)", turn (m.turns(b + 1, :)), list (x(:)' - m.origins(b + 1, :)));
end

## a link; some masses are parameters
function [text, m] = link_text (m, b)
  body = m.body(b);
  rows = strjoin (arrayfun (@(i) list (body.inertia(i, :)), 1:3, "UniformOutput", false), ", ");
  R = turn (m.turns(b + 1, :));
  mass = hundredths (body.mass);
  if (body.parameter)
    mass = sprintf ("mu%d", b);
    m.parameters{end + 1} = sprintf ("%s = %.2f*kg", mass, body.mass);
  end
  more = "";
  if (! isempty (m.cut_link) && m.cut_link == b)
    more = [", cut = " m.joint(b).name];
  end
  text = ...
      sprintf ("link(%s, mass = %s, centre = %s, inertia = transpose(%s) . matrix(%s) . %s%s)", ...
               body.name, mass, point_text (m, ...
      b, body.com), ...
                  R, rows, R, more);
end

function text = joint_text (m, joint, options)
  if (strcmp (joint.type, "rolling"))
    text = ...
        sprintf (["rolling(%s, %s, %s, at = %s, child_at = %s, normal = %s, axis = %s, radius " ...
                  "= %s)"], joint.name, body_name (joint.parent), ...
                    body_name (joint.child), point_text (m, joint.parent, ...
                        joint.point_a), point_text (m, joint.child, joint.point_b), ...
                    integers (joint.whole_second), integers (joint.whole_axis), ...
                        hundredths (joint.radius));
    return;
  end
  place = @(word, b, x, w) sprintf (", %sat = %s, %srotation = transpose(%s) . %s", word, ...
                                    point_text (m, b, x), word, turn (m.turns(b + 1, :)), ...
                                    turn (w));
  own = "";
  if (any (strcmp (joint.type, ...
                   {"revolute", "prismatic", "helical", "cylindrical", "universal", "planar"})))
    own = [", axis = " integers(joint.whole_axis)];
  end
  switch (joint.type)
    case "helical"
      own = [own ", pitch = " hundredths(joint.pitch)];
    case "universal"
      own = [own ", second_axis = " integers(joint.whole_second)];
    case {"spherical", "free"}
      if (! isempty (joint.sequence))
        own = [", orientation = [" strjoin({"x", "y", "z"}(joint.sequence), ", ") "]"];
      end
  end
  text = ...
      sprintf ("%s(%s, %s, %s%s%s%s%s)", joint.type, joint.name, body_name (joint.parent), ...
               body_name (joint.child), ...
                  place ("", joint.parent, joint.point_a, joint.quaternion_a), place ("child_", ...
                      joint.child, joint.point_b, joint.quaternion_b), own, options);
end

function text = tree_options (m, joint)
  text = "";
  if (m.auto || strcmp (joint.type, "fixed"))
    return;
  end
  if (joint.named)
    q = joint.q;
    text = [", coordinates = [" strjoin(q, ", ") "]"];
    if (numel (q) == 1)
      text = [", coordinate = " q{1}];
    end
  end
  if (any (joint.friction))
    text = [text ", friction = " ...
              one_or_list(arrayfun (@hundredths, joint.friction', "UniformOutput", false))];
  end
  if (any (cellfun (@ischar, joint.motion)))
    texts = joint.motion;
    texts(! cellfun (@ischar, texts)) = {"false"};
    text = [text ", motion = " one_or_list(texts)];
  end
end

function text = one_or_list (texts)
  text = ["[" strjoin(texts, ", ") "]"];
  if (isscalar (texts))
    text = texts{1};
  end
end

function text = force_text (m, f)
  word = "force";
  at = sprintf (", at = %s", point_text (m, f.body, f.point));
  if (any (f.torque))
    [word, at] = deal ("torque", "");
  end
  text = sprintf ("%s(given, %s, vector = %s, frame = %s%s)", word, body_name (f.body), ...
                  list (f.vector), f.frame, at);
end

function text = spring_text (m, s, form, numbers)
  ends = ...
      sprintf ("parent = %s, at = %s, child = %s, child_at = %s", body_name (s.a), ...
               point_text (m, ...
      s.a, s.point_a), body_name (s.b), ...
                  point_text (m, s.b, s.point_b));
  text = sprintf (form, ends, numbers{:});
end
