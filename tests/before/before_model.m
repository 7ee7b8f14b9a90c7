## [m, given] = before_model (scene, ...)
## Build the model of a scene (before_scenes); options as of gsmbp_build. Its parameters are those
## of starts.txt, GIVEN the other values there.

function [m, given] = before_model (scene, varargin)
  m = gsmbp_build (scene.file, "directory", scene.folder, varargin{:});
  given = before_starts (scene.name);
  for name = fieldnames (given)'
    if (! any (strcmp (name{1}, [m.states(:); m.inputs(:)])))
      m = gsmbp_set (m, name{1}, given.(name{1}));
      given = rmfield (given, name{1});
    end
  end
end
