## m = bench_scene (name, out): the model of an example or bench system, derived anew if its scene
## is the younger; [] if there is no scene. ladderN comes from systems/ladder40.mac with another
## number of loops.

function m = bench_scene (name, out)
  here = fileparts (fileparts (mfilename ("fullpath")));
  root = fileparts (fileparts (here));
  m = [];
  files = {fullfile(root, "examples", name, [name ".mac"]), ...
           fullfile(here, "systems", [name ".mac"])};
  loops = sscanf (name, "ladder%d");
  if (! isempty (loops) && ! exist (files{2}, "file"))
    files{2} = ladder (fullfile (here, "systems", "ladder40.mac"), loops, ...
                       fullfile (out, [name ".mac"]));
  end
  there = cellfun (@(f) exist (f, "file") > 0, files);
  if (any (there))
    scene = files{find(there, 1)};
    if (older (fullfile (out, [name ".json"]), ...
               [{scene}; glob(fullfile (root, "gsmbp", "*")); ...
                glob(fullfile (root, "share", "actuators", "*"))]))
      gsmbp_derive (scene, out);
    end
    m = gsmbp_build (name, "directory", out);
  end
end

function file = ladder (template, loops, file)
  text = strrep (fileread (template), "n_ : 40", sprintf ("n_ : %d", loops));
  text = strrep (text, "\"ladder40\"", sprintf ("\"ladder%d\"", loops));
  if (! exist (file, "file") || ! strcmp (fileread (file), text))
    bench_save (file, text);
  end
end

function yes = older (file, sources)
  yes = ! exist (file, "file") || any (cellfun (@(s) stat (s).mtime, sources) > stat (file).mtime);
end
