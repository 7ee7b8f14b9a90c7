## [times, reached, info, name] = gsmbp__ended (m, times, reached, info, values, number)
## Where the event of the user with that NUMBER has ended a run (INFO 11 of GSSIM): its state is the
## last row, its time the last one of TIMES, INFO is 0 and NAME the event's; else all as it was and
## "".  VALUES: RSTAT.

function [times, reached, info, name] = gsmbp__ended (m, times, reached, info, values, number)
  name = "";
  if (info != 11)
    return;
  endif
  info = 0;
  name = m.events(number).name;
  if (reached == 0 || times(reached) < values(8))
    reached += 1;
    times(reached) = values(8);
  endif
  times = times(1:reached);
endfunction
