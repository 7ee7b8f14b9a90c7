## Wrong values of options and arguments of the functions of octave/, one after the other: each is
## taken, or is an error in one line that begins with the name of the function (or of the handle)
## and is none of Octave's own; an option that is not known is told with those that are.

function test_options ()
  said = warning ();
  loud = onCleanup (@() warning (said));   # "all" with "local" leaves them on
  warning ("off", "all");
  makeinfo_program ("true", "local");   # print_usage typesets the help text, which manual.sh does
  m = gsmbp_hand ("motor_pendulum");
  c = gsmbp_hand ("hand_crank");
  x = [0.1, 0, 0];
  xc = gsmbp_assemble (c, c.initial);
  r = gsmbp_simulate (c, xc, [0, 0.1, 0.2]);
  plan = gsmbp_plan ("quintic", [0, 1], [0, 1]);
  panel = struct ("y", [1; 2], "names", {{"a"}}, "label", "b");
  folder = tempname ();
  png = fullfile (folder, "a.png");
  mkdir (folder);
  before = cd (folder);   # a name of a file may be any text
  guard = onCleanup (@() leave (before, folder));
  options (@(varargin) gsmbp_simulate (m, x, [0, 0.01], ...
      varargin{:}), {"rtol", "method", "step", "atol", "maxstep", "maxsteps", "maxorder", ...
                     "loops", "projection", "drift", ...
           "input", "motion", "gain", "reference", "breaks", "memory", "samples", "modes", ...
               "audit", "start"});
  options (@(varargin) gsmbp_assemble (c, xc, varargin{:}), ...
           {"hold", "time", "tolerance", "branches"});
  options (@(varargin) gsmbp_linear (m, 0, x, 0, varargin{:}), {"reduced", "start"});
  options (@(varargin) gsmbp_modes (m, x, varargin{:}), ...
           {"hold", "steady", "time", "input", "start"});
  options (@(varargin) gsmbp_inverse (c, plan, 0, varargin{:}), ...
           {"side", "input", "guess", "internal"});
  options (@(varargin) gsmbp_timing (m, 0, x, "seconds", 1e-5, varargin{:}), ...
           {"input", "qj", "print"});
  options (@(varargin) gsmbp_trim (m, x, 0, varargin{:}), ...
           {"hold", "free", "time", "tolerance", "margins"});
  options (@(varargin) gsmbp_workprecision (m, x, [0, 0.01], "seconds", 0, varargin{:}), ...
           {"rk4", "dp853", "cvode", "print", "file", "reference"});
  options (@(varargin) gsmbp_hand ("motor_pendulum", varargin{:}), {"precision", "parameters"});
  options (@(varargin) gsmbp_plot (png, [1, 2], panel, varargin{:}), ...
           {"scale", "xlabel", "title", "head"});
  options (@(varargin) gsmbp_animate (c, r, png, varargin{:}), ...
           {"times", "fps", "trace", "view", "up", "speed", "width", "centres", "title"});
  arguments_of (@gsmbp_simulate, {m, x, [0, 0.01]});
  arguments_of (@gsmbp_assemble, {c, xc});
  arguments_of (@gsmbp_linear, {m, 0, x, 0});
  arguments_of (@gsmbp_trim, {m, x, 0});
  arguments_of (@gsmbp_modes, {m, x});
  arguments_of (@gsmbp_timing, {m, 0, x});
  arguments_of (@gsmbp_lqr, {m, plan, [0, 0.5], eye(3), 1});
  arguments_of (@gsmbp_animate, {c, r, png});
  arguments_of (@gsmbp_derive, {"nowhere.mac", folder});
  arguments_of (@gsmbp_inverse, {c, plan, 0});
  arguments_of (@gsmbp_mobility, {c, xc, 0});
  arguments_of (@gsmbp_set, {m, "g", 1});
  arguments_of (@gsmbp_evaluate, {plan, 0, 0, 1});
  arguments_of (@gsmbp_plan, {"quintic", [0, 1], [0, 1]});
  arguments_of (@gsmbp_plan, {"profile", mkpp([0, 1], 1), 1, 0});
  arguments_of (@gsmbp_plan, {"table", [0, 1], [1; 2], 1});
  arguments_of (@gsmbp_csv, {fullfile(folder, "a.csv"), {"a"}, 1});
  arguments_of (@gsmbp_plot, {png, [1, 2], panel});
  left_out (m, png);
end

## An argument is left out, so that the name of an option stands for it: the error names the
## argument, whatever follows.
function left_out (m, png)
  table = {@gsmbp_adjoint, "x0 times", {0}; @gsmbp_assemble, "guess", {}
           @gsmbp_collocate, "x0 xf", {}; @gsmbp_ensemble, "x0 times", {}
           @gsmbp_inverse, "motion times", {}; @gsmbp_linear, "t x v", {}
           @gsmbp_mck, "t x v", {}; @gsmbp_modes, "x", {}; @gsmbp_retime, "path", {}
           @gsmbp_sensitivity, "x v", {}; @gsmbp_simulate, "x0 times", {}
           @gsmbp_sweep, "x0 times", {}; @gsmbp_timing, "t x", {}; @gsmbp_trim, "x v", {}
           @gsmbp_workprecision, "x0 times", {}; @gsmbp_lqr, "motion times", {1, 1}
           @gsmbp_animate, "result", {png}; @gsmbp_report, "r", {png}
           @(m, varargin) gsmbp_point(m, "p", varargin{:}), "t q", {}
           @(m, varargin) gsmbp_operational(m, "p", varargin{:}), "t q u", {}
           @(m, varargin) gsmbp_reach(m, "p", varargin{:}), "P R", {}
           @(m, varargin) gsmbp_drive(varargin{:}), "cycle", {}
           @(m, varargin) gsmbp_cylinder(varargin{:}), "cycle", {}
           @(m, varargin) gsmbp_control(m, varargin{:}), "e", {"lqr"}
           @(m, varargin) gsmbp_schedule({}, "s", varargin{:}), "values", {}};
  bad = {};
  for row = table'
    names = strsplit (row{2}, " ");
    for k = 1:numel (names)
      given = [repmat({0}, 1, numel (names)), row{3}];
      given{k} = "steady";
      for more = {{}, {"x"}, {"x", 1}}
        found = complaint (row{1}, [{m}, given, more{1}]);
        expected = sprintf (["^gsmbp_\\w+: argument %s: expected no text, found \"steady\"; " ...
                             "options follow the arguments \\(%s\\): write \\[\\] for one"], ...
                            names{k}, strjoin (names, ", "));
        if (isempty (regexp (found, expected, "once")))
          bad{end+1} = sprintf ("%s, %s: %s", func2str (row{1}), names{k}, found);
        end
      end
    end
  end
  bad{end+1} = told (@gsmbp_trim, {m, [0.1, 0, 0], "steady", "s"}, ...
                     "^gsmbp_trim: argument v: expected no text, found \"steady\"");
  report ("gs.given.refuse_words", bad);
end

function leave (before, folder)
  cd (before);
  confirm_recursive_rmdir (false, "local");
  rmdir (folder, "s");
end

function list = wrong_values ()
  list = {NaN, -1, {}, "x", struct("a", 1), [], 1i, @sin, ones(3, 3), "", {1}, Inf, true(1, 2), ...
          int8(3)};
end

function options (f, names)
  bad = {};
  for name = names
    for value = wrong_values ()
      if (strcmp (name{1}, "input") && is_function_handle (value{1}))
        continue;   # an input that a function gives is rightly called
      end
      bad{end+1} = judged (f, {name{1}, value{1}});
    end
  end
  bad{end+1} = judged (f, {names{1}});
  bad{end+1} = judged (f, {1, 2});
  bad{end+1} = told (f, {names{1}, 1, names{1}, 1}, ["option \"" names{1} "\" is given twice"]);
  near = names{1}([1:end, end]);
  bad{end+1} = told (f, {near, 1}, ["\", did you mean \"" names{1} "\"\\?; known: "]);
  found = complaint (f, {"nonsense", 1});
  bad{end+1} = {"", "an unknown option"}{1 ...
        + isempty(regexp (found, '^gsmbp_\w+: unknown option "nonsense"; known: \w+, ', ...
                          "once"))};
  report (func2str (f), bad);
end

function arguments_of (f, good)
  bad = {};
  for k = 1:numel (good)
    for value = wrong_values ()
      given = good;
      given{k} = value{1};
      bad{end+1} = judged (f, given);
    end
  end
  report (func2str (f), bad);
end

function report (what, bad)
  bad = bad(! cellfun (@isempty, bad));
  word = regexp (what, 'gsmbp_\w+', "match", "once");
  if (! gsmbp_check (sprintf ("%s: wrong values", word), isempty (bad)))
    printf ("  %s\n", bad{:});
  end
end

## "" where the error says WHAT
function text = told (f, given, what)
  text = complaint (f, given);
  if (! isempty (regexp (text, what, "once")))
    text = "";
  end
end

## "" where it is taken or told well
function text = judged (f, given)
  text = complaint (f, given);
  own = ! isempty (regexp (text, '^(gsmbp_\w+|motor_pendulum\.\w+|hand_crank\.\w+): ', "once")) ...
      && ! any (text == "\n");
  if (own || strcmp (text, "") || strncmp (text, "Invalid call to gsmbp_", 22))
    text = "";
  else
    text = sprintf ("%s: %s", strtrim (regexprep (disp (given), '\s+', " ")), text);
  end
end

function text = complaint (f, given)
  text = gsmbp_complaint (@() quiet (f, given));
end

function quiet (f, given)
  evalc ("f (given{:});");
end
