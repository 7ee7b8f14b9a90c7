## runs = before_read (file, scene)
## Read the runs of SCENE from the lines of before_line in FILE: a row of structs as of before_run;
## empty where FILE has none. A scene that was left out has one with the name "-".

function runs = before_read (file, scene)
  persistent text name;
  if (! strcmp (name, file))
    [text, name] = deal (["\n" fileread(file)], file);
  end
  runs = before_empty ()([]);
  for line = regexp (text, ['(?<=\n)' regexptranslate("escape", scene) ' ([^\n]*)'], "tokens")
    runs(end + 1) = parsed (line{1}{1});
  end
end

## the line of before_line without its scene
function run = parsed (line)
  run = before_empty ();
  parts = strsplit (line, " | ");
  if (strncmp (line, "- left out", 10))
    return;
  end
  run.name = parts{1};
  for part = parts(2:end)
    [word, rest] = strtok (part{1}, " ");
    numbers = sscanf (rest, "%f")';
    switch (word)
      case "info", [run.info, run.reached] = num2cell (numbers){:};
      case {"counts", "x", "error"}, run.(word) = numbers;
      case "events", run.happened = numbers(1); run.times = numbers(2:end);
      case "modes", run.events = rest(2:end);
      case "warned", run.warned = rest(2:end);
      case "stopped", [run.id, run.text] = strtok (rest(2:end), " "); run.text(1) = [];
    end
  end
end
