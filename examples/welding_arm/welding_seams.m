## paths = welding_seams (SPEED): the two seams: a straight one of 0.5 m, welded at SPEED [m/s], the
## wire leaning by 0.25 rad ahead at its begin and as much back at its end; and 160 degrees round a
## tube of 0.12 m, at 0.3 m/s, the wire leaning outwards by 0.45 rad all the way.

function paths = welding_seams (speed)
  down = diag ([-1, 1, -1]);
  about = @(k, a) expm (a * [0, -(k == 3), k == 2; k == 3, 0, -(k == 1); -(k == 2), k == 1, 0]);
  leans = cat (3, about (1, 0.25) * down, about (1, -0.25) * down);
  paths{1} = gsmbp_path ("line", [0.6, 0.6; -0.25, 0.25; 0.4, 0.4], "speed", speed, ...
                         "acceleration", 2.5, "jerk", 40, "rotations", leans);
  half = 80 * pi / 180;
  on_tube = @(a) [0.6; 0; 0.4] - 0.12 * [cos(a); sin(a); 0 * a];
  leans = cat (3, about (3, -half) * about (2, 0.45) * down, ...
               about (3, half) * about (2, 0.45) * down);
  paths{2} = gsmbp_path ("circle", [on_tube(-half), on_tube(0), on_tube(half)], "speed", 0.3, ...
                         "acceleration", 2, "jerk", 30, "rotations", leans);
endfunction
