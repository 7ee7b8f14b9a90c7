## open_report (FILE): for the driver FILE of an example: go to its folder, make out/, put the
## package on the path, and write all that is printed from here on to out/report.txt too (until
## `diary off`).

function open_report (file)
  warning ("off", "Octave:shadowed-function");   # run.m has the name of a function of Octave
  cd (fileparts (file));
  addpath (fullfile (pwd (), "..", "..", "octave"));
  [~, ~] = mkdir ("out");
  report = fullfile ("out", "report.txt");
  if (exist (report, "file"))
    delete (report);
  endif
  diary (report);
endfunction
