## gsmbp_writers (file): the writers of files of Octave, one call each, for tests/writers/check. The
## file has a line "writer folder version" for each call. Prints JOB, the line, then what the writer
## says, then DONE or FAILED.

function gsmbp_writers (file)
  s = models ();
  printf ("READY\n");
  fflush (stdout);
  for line = strsplit (strtrim (fileread (file)), "\n")
    words = strsplit (line{1}, "\t");
    printf ("JOB %s\n", line{1});
    said = "DONE";
    try
      written (s, words{1:2}, str2double (words{3}));
    catch e
      printf ("%s\n", strrep (e.message, "\n", " / "));
      said = "FAILED";
    end_try_catch
    printf ("%s\n", said);
    fflush (stdout);
  endfor
  printf ("END\n");
endfunction

function s = models ()
  s.m = gsmbp_hand ("hand_crank");
  t = linspace (0, 1, 20);
  s.r = gsmbp_simulate (s.m, gsmbp_assemble (s.m, s.m.initial), t);
endfunction

function written (s, writer, folder, version)
  in = @(name) fullfile (folder, name);
  t = linspace (0, version, 100)';
  y = struct ("y", sin (5 * t), "names", {{"y"}}, "label", "y");
  switch (writer)
    case "csv"
      gsmbp_csv (in ("a.csv"), {"t", "y"}, [t, y.y]);
    case "figure"
      gsmbp_plot (in ("b.png"), t, y);
    case "animation"
      gsmbp_animate (s.m, s.r, in ("c.gif"), "times", [0 1] * version / 4);
    case "report"
      gsmbp_report (s.m, s.r, in ("d.html"), "title", sprintf ("run %d", version));
    case "controller"
      gsmbp_controller (proportional (version), folder);
    otherwise
      error ("no writer %s", writer);
  endswitch
endfunction

## a controller as of gsmbp_pid, without the package control
function c = proportional (gain)
  c = struct ("name", "hold", "method", "p", "period", 0.1, "delay", 0, "A", zeros (0), "B", ...
              zeros (0, 2), "C", zeros (1, 0), "D", [-gain, gain], "G", zeros (0, 1), ...
              "measured", {{"y"}}, "driven", {{"u"}}, "references", {{"r"}}, "y0", 0, "r0", 0, ...
              "u0", 0, "limits", [-Inf, Inf], "step_in", 0, "step_out", 0);
endfunction
