## Robots imported from URDF files: mass matrix, velocity terms, gravity and losses of the joints
## against the reference's states; followers as B'MB of the tree. Error: largest difference of an
## array over its largest entry.

function test_reference_urdf ()
  for name = {"origins", "fixed", "tilted", "mimic"}
    against_cases (["urdf_" name{1}], name{1});
  end
  against_cases ("urdf_merged", "fixed");
  floating ();
end

function against_cases (scene, name)
  m = gsmbp_fixture (scene);
  weightless = gsmbp_set (m, "g", 0);
  folder = fullfile (fileparts (mfilename ("fullpath")), "..", "data", "r3_urdf", name);
  ref = jsondecode (fileread (fullfile (folder, "reference.json")));
  spec = jsondecode (fileread (fullfile (folder, "spec.json")));
  own = strrep (m.coordinates, "q_", "");
  leaders = cellfun (@(c) c{1}, rows_of (spec.coordinates), "UniformOutput", false);
  [B, offset] = followers (own, leaders, spec.mimic);
  worst = zeros (1, 4);
  for s = ref.states(:)'
    q = B * by_name (s.q, leaders) + offset;
    u = B * by_name (s.u, leaders);
    found = {B' * m.mas(0, q) * B, B' * weightless.bia(0, q, u), B' * m.bia(0, q, 0 * u)};
    wanted = {numbers(s.M), numbers(s.c), numbers(s.G)};
    worst(1:3) = max (worst(1:3), cellfun (@relative, found, wanted));
  end
  names = {"mass matrix", "velocity terms", "gravity"};
  for k = 1:3
    gsmbp_check (sprintf ("%s: %s, %d states", scene, names{k}, numel (ref.states)), ...
        worst(k), 1e-13);
  end
end

## rows of what jsondecode makes of a list of lists of texts
function c = rows_of (c)
  if (! iscell (c{1}))
    c = num2cell (c, 2);
  end
end

function x = numbers (c)
  if (iscell (c{1}))
    c = horzcat (c{:})';
  end
  x = str2double (c);
end

function e = relative (a, b)
  e = max (abs (a(:) - b(:))) / max (max (abs (b(:))), 1e-3);
end

function x = by_name (values, names)
  x = cellfun (@(n) numbers (values.(n)), names(:));
end

## all joints as B*(leaders) + offset
function [B, offset] = followers (own, leaders, mimic)
  B = zeros (numel (own), numel (leaders));
  offset = zeros (numel (own), 1);
  for i = 1:numel (own)
    if (isfield (mimic, own{i}))
      row = mimic.(own{i});
      B(i,strcmp (leaders, row{1})) = str2double (row{2});
      offset(i) = str2double (row{3});
    else
      B(i,strcmp (leaders, own{i})) = 1;
    end
  end
end

## a floating body, a planar joint, damping and dry friction
function floating ()
  m = gsmbp_fixture ("urdf_floating");
  folder = fullfile (fileparts (mfilename ("fullpath")), "..", "data", "r3_urdf", "floating");
  ref = jsondecode (fileread (fullfile (folder, "reference.json")));
  worst = zeros (1, 3);
  for s = ref.states(:)'
    lost = [zeros(9, 1); 0.25 * s.u(10) + 0.4 * tanh(s.u(10) / 1e-4)];
    worst(1) = max (worst(1), relative (m.mas (0, s.q), s.M));
    worst(2) = max (worst(2), relative (m.bia (0, s.q, s.u) - lost, s.bias));
    worst(3) = max (worst(3), relative (m.bia (0, s.q, 0 * s.u), s.G));
  end
  gsmbp_check ("urdf_floating: mass matrix, bias with losses, gravity", worst, 1e-13);
end
