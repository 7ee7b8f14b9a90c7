## BODY = pose_bodies (MASS, CENTRE, INERTIA): a struct array of rigid bodies: masses (row), mass
## centres (a column each, body axes), inertias about them (cell of 3 x 3). Their poses are
## functions of one variable that give a 4 x 4 x n array.

function body = pose_bodies (mass, centre, inertia)
  body = struct ("mass", num2cell (mass), "centre", num2cell (centre, 1), "inertia", inertia);
end
