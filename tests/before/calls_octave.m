## calls_octave (file, host, out)
## Make the calls of FILE (calls.json) in HOST: "octave", gsmbp_simulate, or "sweep", the program
## that gsmbp_sweep builds. Write a line for each into OUT: its message.

function calls_octave (file, host, out)
  table = jsondecode (fileread (file), "makeValidName", false);
  id = fopen (out, "w");
  for call = table.calls'
    [name, given] = call{1}{:};
    scene = table.scenes.(name);
    given = filled (given, scene);
    m = gsmbp_build (name, "directory", fullfile (getenv ("GSMBP_TEST_DIR"), "calls"));
    fprintf (id, "%s\n", strrep (feval (host, m, given), "\n", " "));
  end
  fclose (id);
end

## with the state and times of the scene where the call has none; options as a list
function given = filled (given, scene)
  for field = {"x0", "times"}
    if (! isfield (given, field{1}))
      given.(field{1}) = scene.(field{1});
    end
  end
  if (isfield (given, "options"))
    given.options = [fieldnames(given.options), struct2cell(given.options)]'(:)';
  else
    given.options = {};
  end
end

function said = octave (m, given)
  if (isfield (given, "par"))
    [said, m] = message (@() gsmbp_set (m, given.par));
  end
  if (! isempty (m))
    said = message (@() gsmbp_simulate (m, given.x0, given.times, given.options{:}));
  end
end

## the message where the sweep is prepared, else of its program, else the reason in its table
function said = sweep (m, given)
  vary = struct (fieldnames (m.par){1}, struct2cell (m.par){1});
  if (isfield (given, "par"))
    vary = given.par;
  end
  vary = structfun (@(value) repmat (value, 1, 3), vary, "UniformOutput", false);   # a list
  place = fullfile (getenv ("GSMBP_TEST_DIR"), "calls", "sweeps", m.name);
  table = [place ".h5"];
  [said, w] = message (@() gsmbp_sweep (m, given.x0, given.times, "vary", vary, "plan", "grid", ...
                                        "program", place, given.options{:}));
  if (isempty (w))
    said = ["(prepared by Octave) " said];
    return;
  end
  [code, text] = system (sprintf ("%s -t 1 -o %s 2>&1", w.program, table));
  if (code != 0)
    said = strrep (strtrim (text), place, "FOLDER");
    return;
  end
  t = load ("-hdf5", table);
  if (isfield (t, "failed"))
    said = cellstr (t.failed.reason){1};
  end
  delete (table);
end

## what a function says: its error, its last warning, or nothing; RESULT is empty after an error
function [said, result] = message (f)
  [said, result] = deal ("accepted", []);
  lastwarn ("", "");
  try
    evalc ("result = f ();");
    if (! isempty (lastwarn ()))
      said = ["warning: " lastwarn()];
    end
  catch e
    said = e.message;
  end
end
