## gsmbp_report: the page is well-formed and of the scene, its poses are those of the model, the
## numbers of its figures those of the run.

function test_report ()
  m = gsmbp_fixture ("report_arm");
  x0 = m.initial + 0.05;
  r = gsmbp_simulate (m, x0, 0:0.01:2, "input", [3; 6], "audit", 1);
  w = gsmbp_workprecision (m, x0, 0:0.5:1, "input", [3; 6], "rk4", [0.01 0.005], "dp853", 1e-6, ...
                           "print", false, "seconds", 0);
  scene = fullfile (fileparts (fileparts (mfilename ("fullpath"))), "scenes", "report_arm.mac");
  file = fullfile (getenv ("GSMBP_TEST_DIR"), "report_arm_run.html");
  gsmbp_report (m, r, file, "scene", scene, "workprecision", w, "frames", 100, "title", ...
                "</main><script>alert(1)</script>");
  text = fileread (file);
  well_formed (text, file);
  poses (m, r, text);
  figures (m, r, text);
  tables (r, w, text);
  pages (m, r, file, text);
  shapes (m);
  bent ();
  nodes ();
end

## a scene without parameters: the nodes of a flexible link by modal data as the links on them stand
function nodes ()
  m = gsmbp_fixture ("flexible_data");
  x0 = m.initial;
  x0(4:5) = [0.1; 0.02];
  r = gsmbp_simulate (m, x0, 0:0.01:0.1);
  file = fullfile (getenv ("GSMBP_TEST_DIR"), "nodes_run.html");
  gsmbp_report (m, r, file, "scene", fullfile (fileparts (fileparts (mfilename ("fullpath"))), ...
                                               "scenes", "flexible_data.mac"));
  d = jsondecode (regexp (fileread (file), 'id="motion">(.*?)</script>', "tokens", "once"){1});
  numbers = @(text) double (typecast (matlab.net.base64decode (text), "single"));
  places = reshape (numbers (d.axes_of_beams), 3, d.beams.places, []);
  all_poses = reshape (numbers (d.poses), 12, numel (d.bodies), []);
  names = cellfun (@(b) b.name, as_cells (d.bodies), "UniformOutput", false);
  on = @(name) all_poses(10:12,strcmp (names, name),:);
  gsmbp_check ("nodes of a flexible link by modal data", ...
               places - [on("rod"), on("rod_tip"), on("rod_mid")], 1e-6);
  gsmbp_check ("... the lines between them", ...
               isequal (sortrows (reshape (d.beams.lines, 2, [])'), [1, 3; 2, 3]));
end
function list = as_cells (list)
  if (! iscell (list))
    list = num2cell (list);
  end
end

## the middle of the axis of a beam, as the point that stands there has it
function bent ()
  m = gsmbp_fixture ("flexible_slider_crank");
  x0 = gsmbp_assemble (m, m.initial);
  r = gsmbp_simulate (m, x0, 0:0.005:0.1);
  file = fullfile (getenv ("GSMBP_TEST_DIR"), "bent_run.html");
  gsmbp_report (m, r, file, "scene", fullfile (fileparts (fileparts (mfilename ("fullpath"))), ...
                                               "scenes", "flexible_slider_crank.mac"));
  d = jsondecode (regexp (fileread (file), 'id="motion">(.*?)</script>', "tokens", "once"){1});
  places = double (reshape (typecast (matlab.net.base64decode (d.axes_of_beams), "single"), ...
                            3, 13, []));
  middle = cell2mat (arrayfun (@(k) m.pnt (d.t(k), r.x(k,1:m.sizes.nq)')(:,1), 1:numel (d.t), ...
                               "UniformOutput", false));
  gsmbp_check ("the bent axis of a beam", max (abs (squeeze (places(:,7,:)) - middle)(:)), 1e-6);
  straight = (places(:,1,:) + places(:,13,:)) / 2;
  gsmbp_check ("... which bends", max (abs (squeeze (straight) - middle)(:)) > 1e-4);
end

## the shapes in the JSON, and what their sizes must be
function shapes (m)
  list = m.json.link_shapes;
  gsmbp_check ("shapes in the JSON", isequal ({list.kind}, {"cylinder", "sphere"}) ...
    && isequal ({list.link}, {"mast", "mast"}) && isequal (cellstr (list(2).sizes), {"2*w"}));
  said = gsmbp_complaint (@() gsmbp_set (m, "w", -1));
  gsmbp_check (["a negative size is refused: " said], any (strfind (said, "link mast: shape")));
end

function well_formed (text, file)
  [status, said] = system (sprintf (["python3 -c 'import sys, xml.dom.minidom as d; " ...
                                     "d.parse(sys.argv[1])' '%s' 2>&1"], file));
  gsmbp_check (["the page is well-formed " said], status == 0);
  gsmbp_check ("a text is no markup", isempty (strfind (text, "<script>alert")) ...
                                        && any (strfind (text, "&lt;script&gt;alert(1)")));
  gsmbp_check ("nothing is fetched", isempty (regexp (text, '(src|href)="?https?:', "once")));
  gsmbp_check ("size [kB]", numel (text) / 1000, 400);
  parts = {"<h1>Report of report_arm</h1>", "<h2>Equations of motion</h2>", "<h2>System graph", ...
           "<h2>Device motor</h2>", "<h2>The laws</h2>", "<h2>The motion</h2>", "<canvas", ...
           "<h2>Coordinates</h2>", "<h2>Speeds</h2>", "<h2>States of devices</h2>", ...
           "<h2>Inputs</h2>", "<h2>Outputs</h2>", "<h2>Energy audit</h2>", ...
           "<h2>Integration</h2>", ...
           "<h2>Speed against error</h2>"};
  for p = parts
    gsmbp_check (["there is " p{1}], any (strfind (text, p{1})));
  end
end

## mass centres and joints as m.ske has them; the rotations are rotations
function poses (m, r, text)
  d = jsondecode (regexp (text, 'id="motion">(.*?)</script>', "tokens", "once"){1});
  all_poses = double (reshape (typecast (matlab.net.base64decode (d.poses), "single"), 12, 3, []));
  gsmbp_check ("frames of the player", numel (d.t) - 100, 0);
  [off, row] = min (abs (r.t - d.t'));
  gsmbp_check ("... are rows of the run", off, 1e-14);
  [off, turned] = deal (0);
  for k = 1:10:numel (d.t)
    points = m.ske (d.t(k), r.x(row(k),1:m.sizes.nq)');
    for b = 2:3
      last = sum (m.skeleton.points(1:b));
      R = reshape (all_poses(1:9,b,k), 3, 3)';
      off = max (off, norm (all_poses(10:12,b,k) + R * d.bodies(b).centre(:) - points(:,last)));
      turned = max (turned, norm (R * R' - eye (3)));
    end
  end
  gsmbp_check ("mass centres in single precision", off, 2e-7);
  gsmbp_check ("rotations are orthogonal", turned, 1e-6);
  kinds = cellfun (@(s) s.kind, solids (d), "UniformOutput", false);
  gsmbp_check ("shapes are drawn", ismember ({"sphere", "cylinder"}, kinds));
  of_boom = cellfun (@(s) s.body == 2 && strcmp (s.kind, "box") && numel (s.m) == 12, solids (d));
  box = solids (d){find (of_boom, 1)};
  L = reshape (box.m(1:9), 3, 3);
  gsmbp_check ("the box of equal inertia", 2 / 12 * (trace (L * L') * eye (3) - L * L') ...
    - [1/50 1/5000 0; 1/5000 21/1000 0; 0 0 1/200], 1e-12);
  named = d.points;
  if (iscell (named))
    named = [named{:}];
  end
  q = r.x(row(11),1:m.sizes.nq)';
  [P, A] = m.pnt (d.t(11), q);
  off = 0;
  for i = 1:numel (named)
    p = named(i);
    b = p.body + 1;
    R = reshape (all_poses(1:9,b,11), 3, 3)';
    off = max ([off; abs(all_poses(10:12,b,11) + R*p.at(:) - P(:,i)); ...
                abs(R*reshape (p.axes, 3, 3)' - A(:,3*i-2:3*i))(:)]);
  end
  gsmbp_check ("points and frames of the scene", isequal ({named.name}, m.points'));
  gsmbp_check ("... where PNT has them", off, 2e-7);
  gsmbp_check ("springs and the force", numel (d.pairs) == 2 && numel (d.arrows) == 1);
end

function list = solids (d)
  list = d.solids;
  if (isstruct (list))
    list = num2cell (list);
  end
end

## the lines, read back from the picture, against the run: half of the last digit that is written
function figures (m, r, text)
  y = [r.x, r.v];
  names = [m.states(:)', m.inputs(:)'];
  seen = false (1, numel (names));
  worst = 0;
  for one = regexp (text, '<svg[^>]*data-x="[^"]*".*?</svg>', "match")
    title = regexp (one{1}, '<title>[^:<]*: ([^<]*)</title>', "tokens", "once");
    if (isempty (title))
      continue;
    end
    [found, column] = ismember (strsplit (title{1}, ", "), names);
    lines = regexp (one{1}, '<polyline[^>]* points="([^"]*)"', "tokens");
    if (! all (found) || numel (lines) != numel (column))
      continue;
    end
    limits = sscanf (regexp (one{1}, 'data-y="([^"]*)"', "tokens", "once"){1}, "%f");
    box = sscanf (regexp (one{1}, 'data-box="([^"]*)"', "tokens", "once"){1}, "%f");
    for k = 1:numel (lines)
      points = reshape (sscanf (strrep (lines{k}{1}, ",", " "), "%f"), 2, []);
      drawn = limits(1) + (box(4) - points(2,:)) / (box(4) - box(2)) * diff (limits);
      worst = max (worst, max (abs (drawn' - y(:,column(k)))) / diff (limits));
      seen(column(k)) = true;
    end
  end
  gsmbp_check ("every state and input has its line", seen);
  gsmbp_check ("lines are those of the run, of the height", worst, 0.5e-2 / 256 * 1.01);
end

function tables (r, w, text)
  gsmbp_check ("the audit's error", any (strfind (text, sprintf ("%.3g.</p>", r.audit.error))));
  gsmbp_check ("calls of the run", any (strfind (text, sprintf ("<td>calls</td><td>%d</td>", ...
                                                               r.stats.calls))));
  gsmbp_check ("errors of the methods", ...
               any (strfind (text, sprintf ("<td>%.2e</td>", w(1).error))));
end

## which page is taken: beside the JSON, given, of another scene
function pages (m, r, file, text)
  beside = fullfile (m.directory, "report_arm.html");
  run_alone = [tempname() ".html"];
  tidy = onCleanup (@() cellfun (@(f) unlink (f), {beside, run_alone}, "UniformOutput", false));
  gsmbp_report (m, r, run_alone);
  gsmbp_check ("without a page: the run alone", ...
               isempty (strfind (fileread (run_alone), "<canvas")));
  page = [regexp(text, '^.*?(?=<h2>The run</h2>)', "match", "once"), "<!-- parts of a run -->"];
  fputs (f = fopen (beside, "w"), page);
  fclose (f);
  gsmbp_report (m, r, run_alone);
  gsmbp_check ("the page beside the JSON", any (strfind (fileread (run_alone), "<canvas")));
  m.scene_hash = "0123";
  said = gsmbp_complaint (@() gsmbp_report (m, r, run_alone));
  gsmbp_check (["another scene is refused: " said], any (strfind (said, "is of another scene")));
  fputs (f = fopen (beside, "w"), strrep (page, "z1 = ", "z1 = system(1)+"));
  fclose (f);
  m.scene_hash = regexp (page, '"hash": "(\w+)"', "tokens", "once"){1};
  said = gsmbp_complaint (@() gsmbp_report (m, r, run_alone));
  gsmbp_check (["a page runs nothing here: " said], any (strfind (said, "expected an expression")));
end
