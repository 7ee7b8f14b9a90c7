## given = before_starts (name)
## Read the values that starts.txt has for the scene NAME: a struct of numbers by the names of
## states, inputs and parameters.

function given = before_starts (name)
  persistent lines;
  if (isempty (lines))
    lines = strsplit (fileread (fullfile (fileparts (mfilename ("fullpath")), "starts.txt")), "\n");
  end
  given = struct ();
  for line = lines(strncmp (lines, [name " "], numel (name) + 1))
    for pair = strsplit (strtrim (line{1}(numel (name) + 1:end)))
      [word, value] = strtok (pair{1}, "=");
      given.(word) = str2double (value(2:end));
    end
  end
end
