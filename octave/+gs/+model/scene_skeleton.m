## s = gs.model.scene_skeleton (json)
## The bodies of the skeletal diagram, ground first, in the order of the columns
## of SKE: columns BODY (names), POINTS (how many), JOINTS (how many of them,
## the first ones, are where joints stand) and, if the JSON tells them, TYPES
## (of these joints, a cell array of words each).  Empty without SKE.  PARTS, a struct array, is
## what stands behind the bodies in SKE: name, kind, bodies (the name of one for each point).

function s = scene_skeleton (json)
  s = struct ("body", {cell(0, 1)}, "points", zeros (0, 1), "joints", zeros (0, 1));
  s.parts = struct ("name", {}, "kind", {}, "bodies", {});
  if (isfield (json, "skeleton_parts"))
    for part = gs.model.struct_list (json.skeleton_parts)
      s.parts(end+1) = struct ("name", part.name, "kind", part.kind, "bodies", {part.bodies(:)'});
    endfor
  endif
  if (isfield (json, "skeleton") && ! isempty (json.skeleton))
    list = json.skeleton(:);
    s.body = {list.body}(:);
    s.points = double ([list.points](:));
    s.joints = double ([list.joints](:));
    if (isfield (list, "types"))
      s.types = cellfun (@cellstr, {list.types}(:), "UniformOutput", false);
    endif
  endif
endfunction
