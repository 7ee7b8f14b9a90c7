## records = gs.sweep.record_names (told, names, units, kept, table, times)
## What the table of a sweep is made of, beside its chunks, as records of gs.sweep.job_text: what it
## is, names and units of its columns, the samples, the times.

function records = record_names (told, names, units, kept, table, times)
  lines = @(list) sprintf ("%s\n", list{:});
  whole = [kept.whole];
  of_whole = kept(whole);
  records = {"description", told; "names", lines(names); "units", lines(units); "varied", ...
             columns(table); "samples", table'; "tout", times(:); "whole", ""; "whole_units", ""};
  if (! isempty (of_whole))
    records{7,2} = lines ({of_whole.name});
    records{8,2} = lines ({of_whole.unit});
  endif
endfunction
