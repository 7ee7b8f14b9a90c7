## text = gs.report.still_picture (d, place, turn)
## One instant of a scene (gs.report.drawn_scene) as SVG, for browsers without WebGL: solids by
## their axes, pairs by lines, as the player's camera sees them at the start, without perspective.

function text = still_picture (d, place, turn)
  [az, el] = deal (d.view(1), d.view(2));
  dir = [cos(el)*cos(az), cos(el)*sin(az), sin(el)] * d.up;
  x = cross (d.up(3,:), dir);
  x /= norm (x);
  flat = [x; cross(dir, x)];
  pose = @(b) pose_of (b, place, turn);
  text = "";
  for s = d.solids
    text = [text, solid_lines(s{1}, pose (s{1}.body), flat, d)];
  endfor
  axes_ = d.target' - reshape (d.axes_of_beams(1,:), 3, []);
  for beam = d.beams
    for line = reshape (beam{1}.lines, 2, [])
      text = [text, line_of(-flat * axes_(:,line), d.extent, beam{1}.color, 4)];
    endfor
    axes_(:,1:beam{1}.places) = [];
  endfor
  for p = d.pairs
    ends = [point(pose (p{1}.body), p{1}.at), point(pose (p{1}.child), p{1}.child_at)];
    text = [text, line_of(flat * (ends - d.target'), d.extent, [.3 .3 .3], 2)];
  endfor
  for p = d.points
    text = [text, name_at(flat * (point (pose (p{1}.body), p{1}.at) - d.target'), d.extent, ...
                          p{1}.name)];
  endfor
  text = [sprintf(["<div id=\"still\"><svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" " ...
                   "width=\"640\" height=\"480\" viewBox=\"-320 -240 640 480\">\n" ...
                   "<title>The scene at t = %.6g s</title>\n"], d.t(1)), text, ...
          sprintf("</svg></div>\n")];
endfunction

function P = pose_of (b, place, turn)
  P = [eye(3), zeros(3, 1)];
  if (b > 0)
    P = [reshape(turn{b}(1,:), 3, 3)', place{b}(1,:)'];
  endif
endfunction

function p = point (P, at)
  p = P * [at(:); 1];
endfunction

## a point of the scene with its name
function text = name_at (p, extent, name)
  p .*= 420 / extent * [1; -1];
  text = sprintf (["<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" /><text x=\"%.1f\" y=\"%.1f\" " ...
                   "font-size=\"12\">%s</text>\n"], p, p + [5; -5], gs.text.html_escaped (name));
endfunction

## the longest axis of a solid as a thick line, and an outline of what is not a rod
function text = solid_lines (s, P, flat, d)
  L = reshape (s.m(1:9), 3, 3);
  c = s.m(10:12)';
  half = [0.5, 0.5, 0.5, 1](strcmp (s.kind, {"box", "edges", "cylinder", "sphere"}));
  L(:,1:2) *= 1 + strcmp (s.kind, "cylinder");
  text = "";
  for k = 1:3
    ends = [point(P, c - half * L(:,k)), point(P, c + half * L(:,k))];
    text = [text, line_of(flat * (ends - d.target'), d.extent, s.color, 2)];
  endfor
endfunction

function text = line_of (p, extent, color, width)
  text = sprintf (["<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"#%02x%02x%02x\" " ...
                   "stroke-width=\"%d\" />\n"], 420 / extent * [1; -1] .* p, ...
                  round (255 * color), width);
endfunction
