## files = gs.controller.target_needs (text, kind)
## The files of the run time that define what TEXT calls, and what they call themselves: KIND "f",
## Fortran (solve/plain, so that no library is needed), or "c", with the C of share/controllers.

function files = target_needs (text, kind)
  home = gs.files.own_place ("share", {"fortran", "engine/core"}{1 + (kind == "c")});
  all_ = [glob(fullfile (home, "*", ["*." kind])); ...
          glob(fullfile (home, "solve", "plain", ["*." kind]))];
  defines = '^ +(?:\w[\w ]* +)?(?:SUBROUTINE|FUNCTION) +(GS\w+)';
  if (kind == "c")
    all_ = [all_; glob(gs.files.own_place ("share", "controllers", "*.c"))];
    for header = {"arith", "expressions", "sines"}   # what these put in line calls, too
      text = [text, fileread(fullfile (home, "gsmbp", [header{1} ".h"]))];
    endfor
    defines = '^(gs\w+) \(';
  endif
  texts = cellfun (@(file) plain (fileread (file), kind), all_, "UniformOutput", false);
  names = cellfun (@(t) [regexp(t, defines, "tokens", "lineanchors"){:}], texts, ...
                   "UniformOutput", false);
  taken = false (size (all_));
  asked = words (plain (text, kind));
  while (true)
    more = ! taken & cellfun (@(own) any (ismember (own, asked)), names);
    if (! any (more))
      break;
    endif
    taken |= more;
    asked = words (strjoin (texts(more)', "\n"));
  endwhile
  files = all_(taken)';
endfunction

## without comments
function text = plain (text, kind)
  if (kind == "c")
    text = regexprep (text, '/\*.*?\*/', " ");
  else
    text = regexprep (text, '^[Cc*][^\n]*', "", "lineanchors");
  endif
endfunction

function list = words (text)
  list = unique (regexp (text, '\<(GS|gs)\w+', "match"));
endfunction
