## word = gs.run.stopped_word (who, m, info, at, say)
## What ended a run of the model M from outside, by INFO of glue/patience.h: "interrupted",
## "timeout", "" where nothing did.  SAY: a warning tells so, and how far it came (AT).  Ctrl-C
## under another function of the package ends that too: half a run is no part of its result.

function word = stopped_word (who, m, info, at, say)
  word = "";
  if (! any (info == [9, 10]))
    return;
  endif
  word = {"interrupted", "timeout"}{info - 8};
  if (info == 9 && within_another (who, dbstack ("-completenames")))
    m.module ("interrupt");
  endif
  if (say)
    warning ("gsmbp:stopped", "%s: %s: %s %s; the result has what there is so far", who, m.name, ...
             gs.run.stopped_text (word), at);
  endif
endfunction

## is one of the callers of WHO in a file of the package that does not give such results itself?
function yes = within_another (who, stack)
  folder = [gs.files.own_place("octave") filesep];
  stack(1:find (strcmp ({stack.name}, who), 1)) = [];
  here = {stack(strncmp ({stack.file}, folder, numel (folder))).file};
  [~, names] = cellfun (@fileparts, here, "UniformOutput", false);
  own = '^gsmbp_(simulate|ensemble|sweep|_sweep\w*)$';
  yes = any (cellfun (@isempty, regexp (names, own, "once")));
endfunction
