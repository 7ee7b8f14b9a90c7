## p = welding_plan (M, SPEED): the task of the arm, sampled each 5 ms: from its rest to a straight
## seam, which it welds at SPEED [m/s], to a seam round a tube, and back.
##
## p.t [s], p.q (rows) and p.motion, the spline through them; p.seams: of both seams the path (of
## gsmbp_path), begin and end [s] and what gsmbp_reach said.

function p = welding_plan (m, speed)
  rest = [0; -0.3; 0.4; 0; 0.6; 0];
  paths = welding_seams (speed);
  [p.t, p.q] = deal (0, rest);
  for k = 1:2
    seam.path = paths{k};
    own = (0:0.005:seam.path.times(2) + 0.005)';
    f = gsmbp_along (seam.path, own);
    [q, seam.told] = gsmbp_reach (m, "wire", f.p, f.R, "start", p.q(:,end));
    p = added (p, transfer (p.q(:,end), q(:,1)));
    seam.times = p.t(end) + own([1, end])';
    p = added (p, q);
    p.seams(k) = seam;
  endfor
  p = added (p, transfer (p.q(:,end), rest));
  p.motion = gsmbp_plan ("table", p.t, p.q', 3);
  p.q = p.q';
endfunction

function p = added (p, q)
  p.t = [p.t, p.t(end) + 0.005 * (1:columns (q) - 1)];
  p.q = [p.q, q(:,2:end)];
endfunction

## from rest to rest, the six joints together; a tenth of a second at rest after it
function q = transfer (from, to)
  move = gsmbp_plan ("double_s", [from, to], "speed", [1, 1, 1.2, 2, 2, 2.5], "acceleration", ...
                     [3, 3, 3, 8, 8, 10], "jerk", [30, 30, 30, 80, 80, 100]);
  q = gsmbp_evaluate (move, 0:0.005:move.breaks(end) + 0.1);
endfunction
