## name = gs.events.missing_at_events (m)
## The first subroutine that derivatives through events of the model M need and that it was emitted
## without, or "".

function name = missing_at_events (m)
  own = strcmp ({m.events.kind}, "event");
  needed = {"evp", "rsp", "urp"};
  needed = needed([! isempty(m.events), any(! own), any(own & gs.events.changing_events (m))]);
  missing = setdiff (needed, m.subroutines);
  name = "";
  if (! isempty (missing))
    name = toupper (missing{1});
  endif
endfunction
