## text = gs.model.run_maxima (caller, script, scene, folder, word...)
## A script of the tree that lets Maxima read the scene file and write into the folder, and takes
## the words as well: what it says. Warnings of Maxima about the scene are warnings of the caller
## ("gsmbp:derive"); an error is one line.

function text = run_maxima (caller, script, scene, folder, varargin)
  if (! exist (scene, "file"))
    error ("%s: there is no scene file %s", caller, scene);
  endif
  words = {script, make_absolute_filename(scene), make_absolute_filename(folder), varargin{:}};
  quoted = cellfun (@(s) ["'" strrep(s, "'", "'\\''") "'"], words, "UniformOutput", false);
  tell = {"", "GSMBP_TELL=/dev/tty "}{1 + gs.text.is_terminal()};
  [status, text] = system (sprintf ("%s%s 2>&1 && times", tell, strjoin (quoted, " ")));
  if (status != 0)
    lines = regexp (text, '^derive: ([^\n]*)', "tokens", "lineanchors");
    if (isempty (lines))
      error ("%s: %s: %s", caller, scene, strtrim (text));
    endif
    error ("%s: %s", caller, lines{end}{1});
  endif
  for line = regexp (text, '^gsmbp\w*: [^\n]*', "match", "lineanchors")
    warning ("gsmbp:derive", "%s: %s: %s", caller, scene, line{1});
  endfor
endfunction
