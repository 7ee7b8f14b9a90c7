## s = speed_system (name, out): the system of systems/NAME.mac derived, in both modes and pass by
## pass, and its numbers as OUT/NAME/model.txt.
##
## s: name, scene (its name in Fortran), n, loop (whether it has loops: then no model.txt), folder,
## model; derive: mode, requests (M+bias, FD, all: ID, M, bias, FD; LIN, batch), CPU seconds; modes
## ("lit": parameters at run time, "num": compiled in); operations.MODE.WORD: mul add div sqrt trig
## (words inv mas fwd lin jac); passes: mode, word and operations of inv mas fwd lin (NaN: not asked
## for) without trig, the passes added up.

function s = speed_system (name, out)
  here = fileparts (mfilename ("fullpath"));
  scene = fullfile (fileparts (here), "systems", [name ".mac"]);
  s.name = name;
  s.folder = fullfile (out, strrep (name, "+", ""));    # Maxima cannot open folders with a plus
  s.model = fullfile (s.folder, "model.txt");
  [~, ~] = mkdir (s.folder);
  s.derive = struct ("mode", {}, "requests", {}, "cpu", {});
  for mode = {"lit", "num"}
    for part = {"", "_lin", "_jac", "_v"}
      [~, ~] = mkdir (fullfile (s.folder, [mode{1} part{1}]));
    end
    [spent, named] = ...
        maxima (here, s.folder, sprintf (["speed_derive(\"%s\", \"%s\", \"%s\")$ " ...
                                          "speed_model(\"%s\", \"%s\")$"], ...
        scene, s.folder, mode{1}, scene, s.model),
      'SPEED (\S+) (\S+) ([\d.]+)', 'NAME (\S+)');
    s.scene = named{1}{1};
    for one = spent
      s.derive(end+1) = struct ("mode", one{1}{1}, "requests", one{1}{2}, "cpu", ...
                                str2double (one{1}{3}));
    end
  end
  s.modes = {"lit", "num"};
  if (strcmp (fileread (source (s, "lit")), fileread (source (s, "num"))))
    s.modes = {"lit"};    # this GSMBP knows no other
    s.derive(strcmp ({s.derive.mode}, "num")) = [];
  end
  for mode = s.modes
    [s.operations.(mode{1}), s.n, s.loop] = speed_operations (fullfile (s.folder, mode{1}, ...
          [s.scene ".json"]));
    s.operations.(mode{1}).lin = NaN (1, 5);
    if (any (strcmp ({s.derive.requests}, "LIN")))
      s.operations.(mode{1}).lin = speed_operations (fullfile (s.folder, [mode{1} "_lin"], ...
            [s.scene ".json"])).lin;
    end
    s.operations.(mode{1}).jac = NaN (1, 5);
    if (any (strcmp ({s.derive.requests}, "JAC")))
      s.operations.(mode{1}).jac = speed_operations (fullfile (s.folder, [mode{1} "_jac"], ...
            [s.scene ".json"])).jac;
    end
  end
  s.passes = struct ("mode", {}, "word", {}, "inv", {}, "mas", {}, "fwd", {}, "lin", {});
  for mode = s.modes
    for one = maxima (here, s.folder, ...
                      sprintf ("speed_passes(\"%s\", \"%s\", \"%s\")$", scene, s.folder, ...
                               mode{1}), 'PASS (\d+|-) (\S+)')
      if (strcmp (one{1}{1}, "-"))
        s.passes(end+1) = struct ("mode", mode{1}, "word", [one{1}{2} " (failed)"], "inv", NaN, ...
                                  "mas", NaN, "fwd", NaN, "lin", NaN);
        continue;
      end
      c = speed_operations (fullfile (s.folder, "passes", mode{1}, one{1}{1}, [s.scene ".json"]));
      if (! isfield (c, "lin"))
        c.lin = NaN (1, 5);
      end
      s.passes(end+1) = struct ("mode", mode{1}, "word", one{1}{2}, "inv", sum (c.inv(1:3)), ...
                                "mas", sum (c.mas(1:3)), "fwd", sum (c.fwd(1:3)), "lin", ...
                                sum (c.lin(1:3)));
    end
  end
end

function file = source (s, mode)
  file = fullfile (s.folder, mode, [s.scene ".f"]);
end

## what the patterns find in the log of a run of Maxima
function varargout = maxima (here, folder, statement, varargin)
  root = fileparts (fileparts (fileparts (here)));
  log = fullfile (folder, "maxima.log");
  text = sprintf ("load(\"%s/gsmbp/gsmbp.mac\")$ load(\"%s/speed.mac\")$ %s", root, here, ...
                  statement);
  [status, ...
   message] = system (sprintf ("GSMBP_TIMEOUT=900 '%s/share/make/maxima' '%s' '%s' 2>&1", root, ...
                               log, text));
  if (status != 0)
    error ("bench: %s:\n%s", statement, message);
  end
  varargout = cellfun (@(pattern) regexp (fileread (log), pattern, "tokens"), varargin, ...
                       "UniformOutput", false);
end
