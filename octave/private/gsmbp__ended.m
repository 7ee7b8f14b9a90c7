## [times, reached, info, name] = gsmbp__ended (m, times, reached, info, values, events)
## Where an event of the user has ended a run (INFO 11 of GSSIM): its state is the last row, its
## time the last one of TIMES, INFO is 0 and NAME the event's; else all as it was and "".  VALUES:
## RSTAT, EVENTS: the record of the events.

function [times, reached, info, name] = gsmbp__ended (m, times, reached, info, values, events)
  name = "";
  if (info != 11)
    return;
  endif
  info = 0;
  ends = [m.events.ends];
  here = events(2,events(1,:) == values(8));
  name = m.events(here(find (ends(here), 1))).name;
  if (reached == 0 || times(reached) < values(8))
    reached += 1;
    times(reached) = values(8);
  endif
  times = times(1:reached);
endfunction
