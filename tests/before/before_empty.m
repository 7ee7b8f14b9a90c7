## run = before_empty (): the fields of a run, all of them empty:
##
##     name      of before_plan
##     info      INFO; empty where the run was refused
##     reached   the time [s]
##     counts    calls, steps, failed steps, projections
##     x         the last state; after it the memory of sampled devices, the energy that passed
##               (audit), derivatives by the parameter (sensitivity)
##     happened  the number of events
##     times     of the first twenty [s]
##     events    their names and modes, one text
##     warned    the identifier of the last warning
##     id, text  of the error of a run that is refused or fails
##     error     allowed of x and of times, see before_record

function run = before_empty ()
  run = struct ("name", "-", "info", [], "reached", NaN, "counts", [], "x", [], "happened", 0, ...
                "times", [], "events", "", "warned", "", "id", "", "text", "", "error", [NaN, NaN]);
end
