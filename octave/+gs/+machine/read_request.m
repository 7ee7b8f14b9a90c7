## s = gs.machine.read_request (who, given)
## What a machine is to do and of what it may be made: the specification of gsmbp_design, checked
## as far as it can be without the scene.

function s = read_request (who, given)
  table = {"motion", [], "any"; "accuracy", [], "numbers"
           "supply", Inf, "any"; "current", Inf, "any"
           "motors", [], "any"; "gears", [], "any"; "screws", [], "any"
           "goal", "mass", {"mass", "energy", "energy_no_recovery", "cost", "power_peak", ...
                            "torque_rms"}
           "inertia_ratio", Inf, "any"; "reserve", 0, [0, 0.9]
           "period", [], "positive"; "delay", 0, "nonnegative"
           "encoder", 0, "nonnegative"; "step_out", 0, "nonnegative"
           "Ms", 1.6, "positive"; "Ms_corners", false, "flag"; "support", cell(0, 2), "any"
           "tolerances", cell(0, 2), "any"; "yield", 0, "whole"; "springs", cell(0, 2), "any"
           "axes", cell(0, 3), "any"; "linear", struct(), "any"
           "tries", 5, "whole"; "file", "", "text"};
  s = gs.given.call_options (who, table, given);
  for name = {"motion", "accuracy", "period"}
    if (isempty (s.(name{1})))
      error ("%s: the specification lacks %s", who, name{1});
    endif
  endfor
  for name = {"supply", "current", "inertia_ratio"}
    v = s.(name{1});
    if (! (isnumeric (v) && isreal (v) && isscalar (v) && v > 0))
      error ("%s: %s: expected a number above 0 (Inf: no limit), found %s", who, name{1}, ...
             gs.text.shown_value (v));
    endif
  endfor
  if (! all (s.accuracy(:) > 0))
    error ("%s: accuracy: expected numbers above 0, found %s", who, ...
           gs.text.shown_value (s.accuracy));
  elseif (s.Ms <= 1)
    error ("%s: Ms: expected a number above 1, found %g", who, s.Ms);
  elseif (s.tries < 1)
    error ("%s: tries: expected 1 or more, found 0", who);
  endif
  s.tolerances = rows_of (who, "tolerances", s.tolerances, "{\"m3\", 0.1}", @is_share);
  s.springs = rows_of (who, "springs", s.springs, "{\"k\", [0 100]}", @is_range);
  s.support = rows_of (who, "support", s.support, "{\"s\", {1.2, \"fixed-supported\"}}", @iscell);
  cellfun (@(one) gs.drive.screw_support (who, one), s.support(:,2), "UniformOutput", false);
  if (s.Ms_corners && rows (s.tolerances) > 5)
    error ("%s: Ms_corners: expected at most 5 tolerances (32 corners), found %d", who, ...
           rows (s.tolerances));
  endif
  if (! isempty (s.file) && ! (numel (s.file) > 5 && strcmpi (s.file(end-4:end), ".html")))
    error ("%s: file: expected a name that ends in .html, found %s", who, s.file);
  endif
  s.motors = gs.drive.given_parts (who, "motors", s.motors);
  s.gears = gs.drive.given_parts (who, "gears", s.gears);
  s.screws = gs.drive.given_parts (who, "screws", s.screws);
endfunction

function list = rows_of (who, name, list, example, fits)
  if (isempty (list))
    list = cell (0, 2);
  endif
  if (! (iscell (list) && columns (list) == 2 && iscellstr (list(:,1)) ...
           && all (cellfun (fits, list(:,2)))))
    error ("%s: %s: expected rows as %s, found %s", who, name, example, gs.text.shown_value (list));
  endif
endfunction

function yes = is_share (v)
  yes = isnumeric (v) && isreal (v) && isscalar (v) && v > 0 && v < 1;
endfunction

function yes = is_range (v)
  yes = isnumeric (v) && isreal (v) && numel (v) == 2 && v(1) < v(2);
endfunction
