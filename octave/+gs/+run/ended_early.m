## [times, reached, info, name] = gs.run.ended_early (m, times, reached, info, last, number)
## Where the event of the user with that NUMBER has ended a run (INFO 11 of GSSIM): its state is the
## last row, its time the last one of TIMES, INFO is 0 and NAME the event's; else all as it was and
## "".  LAST: the time of the event.

function [times, reached, info, name] = ended_early (m, times, reached, info, last, number)
  name = "";
  if (info != 11)
    return;
  endif
  info = 0;
  name = m.events(number).name;
  if (reached == 0 || times(reached) < last)
    reached += 1;
    times(reached) = last;
  endif
  times = times(1:reached);
endfunction
