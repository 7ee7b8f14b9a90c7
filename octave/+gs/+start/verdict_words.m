## [word, remedy] = gs.start.verdict_words (number)
## What a verdict of a start (share/engine/core/gsmbp/failures.h) is called, and what its message
## adds in Octave.

function [word, remedy] = verdict_words (number)
  words = gs.text.table_rows ("GS_VERDICTS");
  word = lower (words{number+1});
  close = "; close it by gsmbp_assemble, or have it moved: \"start\", \"project\"";
  remedies = struct ("off", close, "far", close, "none", ...
                     "; try gsmbp_assemble with another guess, or check the lengths", "device", ...
                     "; \"start\", \"project\" takes devices as they are");
  remedy = "";
  if (isfield (remedies, word))
    remedy = remedies.(word);
  endif
endfunction
