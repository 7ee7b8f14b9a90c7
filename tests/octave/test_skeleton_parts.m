## What a skeletal diagram draws between bodies: ends of springs, dampers and cylinders against the
## points that they stand at, centre, axis and rim of discs that roll against the plane; pictures.

function test_skeleton_parts ()
  bars (gsmbp_fixture ("points_bars"));
  disc (gsmbp_fixture ("rolling_disc"));
  slide (gsmbp_fixture ("fluid_hydraulic"));
  if (! isempty (file_in_path (getenv ("PATH"), "gnuplot")))
    pictures (gsmbp_fixture ("points_bars"), gsmbp_fixture ("rolling_disc"));
  end
end

## the columns of a part
function q = part (m, t, q, name)
  parts = m.skeleton.parts;
  k = find (strcmp ({parts.name}, name));
  before = sum (m.skeleton.points) + numel ([parts(1:k-1).bodies]);
  q = m.ske (t, q)(:,before + (1:numel (parts(k).bodies)));
end

function bars (m)
  q = gsmbp_assemble (m, m.initial)(1:3);
  at = @(name) gsmbp_point (m, name, 0, q).position;
  gsmbp_check ("spring: its ends", part (m, 0, q, "s") - [at("top"), at("base")], 1e-15);
  gsmbp_check ("damper: its ends", part (m, 0, q, "h") - [at("r1"), at("c1")], 1e-15);
  parts = m.skeleton.parts;
  gsmbp_check ("kinds and bodies", isequal ({parts.kind}, {"spring", "damper"}) ...
               && isequal (parts(1).bodies, {"coupler", "ground"}) ...
               && isequal (parts(2).bodies, {"rocker", "crank"}));
end

## leaning by 0.4 rad, turned: the lowest point of the rim is on the plane z = 0
function disc (m)
  R = m.par.R;
  lean = 0.4;
  e = [cos(0.6), 0, 0, sin(0.6)];                    # about z
  f = [cos((pi/2 - lean)/2), sin((pi/2 - lean)/2), 0, 0];   # about x
  e = [e(1)*f(1) - e(4)*f(4), e(1)*f(2) - e(4)*f(3), e(1)*f(3) + e(4)*f(2), e(1)*f(4) + e(4)*f(1)];
  q = gsmbp_assemble (m, [0.3; -0.2; R * cos(lean); e(:); zeros(6, 1)], "hold", {"x", "y"})(1:7);
  p = part (m, 0, q, "wheel");
  [axis, spoke] = deal (p(:,2) - p(:,1), p(:,3) - p(:,1));
  gsmbp_check ("disc: centre", p(:,1) - q(1:3), 1e-15);
  gsmbp_check ("disc: axis and spoke", [norm(axis) - R, norm(spoke) - R, axis' * spoke], 1e-14);
  n = axis / R;
  gsmbp_check ("disc: touches the plane", p(3,1) - R * sqrt (1 - n(3)^2), 1e-12);
  gsmbp_check ("disc: rolling", isequal ({m.skeleton.parts.kind}, {"rolling"}) ...
               && isequal (m.skeleton.parts.bodies, {"disc", "disc", "disc"}));
end

## a cylinder on a sliding joint; a motor on a turning one is none
function slide (m)
  gsmbp_check ("cylinder on a joint", isequal ({m.skeleton.parts.name}, {"C"}));
  gsmbp_check ("... its ends", part (m, 0, [0.3; 1], "C") - [0, 0.3; 0, 0; 0, 0], 1e-15);
end

function pictures (bars, disc)
  folder = tempname ();
  mkdir (folder);
  unwind_protect
    file = fullfile (folder, "a.png");
    x = gsmbp_assemble (bars, bars.initial);
    gsmbp_animate (bars, struct ("t", [0; 1], "q", [x(1:3)'; x(1:3)']), file);
    head = strtok (fileread (fullfile (folder, "a.csv")), "\n");
    gsmbp_check ("a picture of spring and damper", stat (file).size > 5000 ...
                 && ! isempty (strfind (head, "s.1.x,s.1.y,s.1.z,s.2.x")) ...
                 && ! isempty (strfind (head, "h.2.z,c1.x,c1.y,c1.z")));
    numbers = dlmread (fullfile (folder, "a.csv"), ",", 1, 0)(1,2:end);
    gsmbp_check ("... its numbers", numbers - [bars.ske(0, x(1:3))(:); bars.pnt(0, x(1:3))(:)]', ...
                 1e-15);
    file = fullfile (folder, "b.gif");
    q = disc.initial(1:7)';
    gsmbp_animate (disc, struct ("t", [0; 0.1], "q", [q; q]), file, "fps", 20, "trace", "disc");
    gsmbp_check ("a moving picture of a disc", stat (file).size > 3000);
  unwind_protect_cleanup
    confirm_recursive_rmdir (false, "local");
    rmdir (folder, "s");
  end_unwind_protect
end
