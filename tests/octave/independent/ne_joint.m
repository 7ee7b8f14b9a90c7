## j = ne_joint (NAME, TYPE, PARENT, CHILD, OPTION, VALUE, ...): one joint of a model, from body
## PARENT to body CHILD (0 is ground).
##
## Its axes stand in the parent at point_a with the axes frame_a (columns), in the child at point_b,
## frame_b; all of them as seen in world axes in the reference configuration, where every body frame
## coincides with the world's. point and frame give both at once. Where the joint's coordinates are
## zero the two coincide. axis, second: unit vectors in joint axes; pitch [m/rad]. orientation: []
## for Euler parameters, else three axes as columns (turns about moving axes). tracked: of a helical
## loop joint, whose turns are counted from q = 0 on (all axes of its loop that turn are parallel to
## it); else any turn closes it. rolling: a thin disc of the child on a plane of the parent, only as
## a loop joint: axis is the disc's, second the plane's normal. damping, stiffness, rest: a number
## for each coordinate (Euler parameters have none).

function j = ne_joint (name, type, parent, child, varargin)
  j = struct ("name", name, "type", type, "parent", parent, "child", child, "point_a", zeros (3, ...
      1), "frame_a", eye (3), "point_b", zeros (3, 1), ...
              "frame_b", eye (3), "axis", [0; 0; 1], "second", [1; 0; ...
                  0], "pitch", 0, "orientation", [], "damping", [], "stiffness", [], "rest", [], ...
              "directions", [], "radius", 0, "tracked", false);
  for k = 1:2:numel (varargin)
    switch (varargin{k})
      case {"point", "frame"}
        j.([varargin{k} "_a"]) = j.([varargin{k} "_b"]) = varargin{k + 1};
      otherwise
        if (! isfield (j, varargin{k}))
          error ("ne_joint: no such option: %s", varargin{k});
        end
        j.(varargin{k}) = varargin{k + 1};
    end
  end
  j.axis /= norm (j.axis);
  j.second /= norm (j.second);
  [nq, nu] = ne_sizes (j);
  for field = {"damping", "stiffness", "rest"}
    if (isempty (j.(field{1})))
      j.(field{1}) = 0;
    end
    j.(field{1})(end+1:nq, 1) = 0;
  end
end
