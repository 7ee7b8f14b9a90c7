## [w, left] = peers_others (w, s, peers, script, words): what a script of this folder prints, as
## peers_rows with the errors beside the truth; LEFT: what it could not do.

function [w, left] = peers_others (w, s, peers, script, words)
  here = fileparts (mfilename ("fullpath"));
  command = sprintf ("cd '%s' && timeout 900 '%s' -W ignore '%s' '%s' %s 2>'%s'", here, ...
                     fullfile (peers, "venv", "bin", "python"), [script ".py"], s.folder, words, ...
                     fullfile (s.folder, [script ".log"]));
  [status, text] = system (command);
  left = regexp (text, '^LEFT (.*)$', "tokens", "lineanchors", "dotexceptnewline");
  left = cellfun (@(t) [script ": " t{1}], left, "UniformOutput", false);
  if (status != 0)
    left{end+1} = sprintf ("%s: status %d, see %s.log", script, status, script);
  end
  for line = regexp (text, '^ROW (\S+) (.*)$', "tokens", "lineanchors", "dotexceptnewline")
    numbers = sscanf (line{1}{2}, "%f")';
    miss = max (abs (numbers(4:end) - s.truth));
    who = strrep (line{1}{1}, "_", " ");
    w = peers_rows (w, who, "", numbers(1), numbers(2), numbers(3), miss);
  end
end
