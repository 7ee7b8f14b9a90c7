## Functions as inputs, and starts: what is wrong with them is one error that names the argument,
## what was expected (with the names of inputs or states) and what was found; nothing ends Octave.

function test_inputs ()
  m = gsmbp_hand ("motor_pendulum");
  functions (m, [0; 0; 0]);
  s = gsmbp_fixture ("sampled_drive");
  free = gsmbp_simulate (s, s.initial, [0, 0.01], "input", @(t, x) zeros (given_of (s), 1));
  gsmbp_check ("beside held outputs a function gives the others", all (isfinite (free.x(:))));
  said = gsmbp_complaint (@() gsmbp_simulate (s, s.initial, [0, 1], "input", ...
                            @(t, x) zeros (77, 1)));
  gsmbp_check ("... or it is told", told (said, sprintf ("gives %d finite", given_of (s))));
  audited ();
  starts (m, gsmbp_hand ("hand_crank"));
  ends (m);
  by_name ();
  ranges (m, gsmbp_hand ("hand_fourbar"));
  unused (m);
end

## ranges in words that name the option and agree with each other
function ranges (m, bar)
  run_ = @(varargin) gsmbp_simulate (m, [0; 0; 0], [0, 0.01], varargin{:});
  few = "option maxsteps: expected a whole number from 0 (no limit) to 2e9, found ";
  one = "option step: expected a finite number above 0, found ";
  plan = gsmbp_plan ("quintic", [0, 0.1], [0, 1]);
  free = bar;
  free.actuated = zeros (0, 1);
  cases = {@() run_("maxsteps", 1e30), [few "1e+30"]
           @() run_("maxsteps", 2^31), [few "2.14748e+09"]
           @() run_("method", "rk4", "step", 0), [one "0"]
           @() run_("method", "rk4", "step", -1), [one "-1"]
           @() run_("step", -1), "option step: expected a finite number >= 0, found -1"
           @() gsmbp_plan("double_s", [0, 1], "speed", 1, "acceleration", 2), ...
           "gsmbp_plan: option jerk: expected one number above 0, found none"
           @() gsmbp_inverse(m, plan, []), ...
           "gsmbp_inverse: argument times: expected one time or more, found none"
           @() gsmbp_inverse(free, plan, 0), ...
           "expected drives or motors, whose joints it moves; found none in this closed chain"};
  for row = cases'
    said = gsmbp_complaint (row{1});
    gsmbp_check (said, told (said, row{2}));
  end
  gsmbp_check ("a run of 2e9 steps at most", isfinite (run_ ("maxsteps", 2e9).x(end)));
end

## options that a run does not use are a warning
function unused (m)
  for row = {{"method", "rk4", "rtol", 1e-6}, {"loops", "svd"}, {"method", "rk4"}, {"rtol", 1e-6}
             "option rtol: method \"rk4\"", "option loops: motor_pendulum", "", ""}
    lastwarn ("");
    evalc ("gsmbp_simulate (m, [0; 0; 0], [0, 0.01], row{1}{:});");
    seen = regexp (lastwarn (), 'option (rtol: method "rk4"|loops: motor_pendulum)|', "match", ...
                   "once");
    gsmbp_check (["what is not used: " lastwarn()], strcmp (seen, row{2}));
  end
end

## inputs by name, in any order, are those by position; a mode that is left out is no zero
function by_name ()
  m = gsmbp_fixture ("control_fivebar");
  x = gsmbp_assemble (m, m.initial);
  run_ = @(v) gsmbp_simulate (m, x, [0, 0.1], "input", v).x(end,:);
  order = {"fy", 5, "D1.v", 12, "t2", 3, "fx", -4};
  [~, place] = ismember (m.inputs, order(1:2:end));
  values = [order{2:2:end}](place);
  gsmbp_check ("inputs by name in a cell array", run_ (order) - run_ (values), 0);
  named = cell2struct (num2cell (values(:)), m.inputs);
  gsmbp_check ("inputs by name in a struct", run_ (named) - run_ (values), 0);
  cases = {{order{1:6}}, "expected fx once, found it 0 times"; {order{:}, "fx", 1}, ...
           "expected fx once, found it 2 times"; {order{1:6}, "fz", 1}, "did you mean"; ...
           {order{1:7}, [1, 2]}, "fx: expected a number, found [1 2]"; ...
           {3}, "expected {name, value"};
  for row = cases'
    gsmbp_check (["inputs by name: " row{2}], told (gsmbp_complaint (@() run_ (row{1})), row{2}));
  end
  m = gsmbp_fixture ("event_breakaway");
  said = gsmbp_complaint (@() m.rhs (0, [0; 0.1]));
  gsmbp_check (["a mode that is left out: " said], told (said, "argument v is missing"));
  gsmbp_check ("a block that slides: acceleration", m.rhs (0, [0; 0.1], [5; 1]) ...
               - [0.1; (5 - 3) / 0.8], 1e-15);
end

## how many inputs are no held outputs
function n = given_of (m)
  n = m.sizes.nv - numel (vertcat (m.controllers.outputs));
end

function yes = told (said, what)
  yes = ! isempty (strfind (said, what)) && ! any (said == "\n");
end

function functions (m, x0)
  wanted = ...
      ["gsmbp_simulate: option input: expected a function v = f (t, x) of the time and the " ...
            "3 states that gives 1 finite number (drive.v); found at t = "];
  cases = {@(t) 1, "called with too many inputs"; @() 1, "called with too many inputs"; ...
           @sin, "Invalid call to sin"; @nowhere_defined, "unable to find function"; ...
           @(t, x) nobody, "'nobody' undefined"; @(t, x) x(7), "out of bound"; ...
           @(t, x) error ("two\nlines"), "\"two lines\""; @(t, x) [1, 2], "it gives [1 2]"; ...
           @(t, x) [], "it gives []"; @(t, x) NaN, "it gives NaN, which is not finite"; ...
           @(t, x) Inf, "it gives Inf"; @(t, x) 1e301, "1e+301, which is not finite"; ...
           @(t, x) 1i, "it gives 0+1i"; @(t, x) "a", "it gives \"a\""; ...
           @(t, x) {1}, "it gives {1}"; @(t, x) disp (1), "it gives \"1\\n\""};
  later = @(f) @(t, x) ifelse_ (t > 0.05, f, t, x);
  for k = 1:rows (cases)
    for f = {cases{k,1}, later(cases{k,1})}
      for method = {"dp853", "rk4", "cvode"}
        said = gsmbp_complaint (@() gsmbp_simulate (m, x0, [0, 0.1], "input", f{1}, ...
                                                    "method", method{1}));
        good(method_place (method{1})) = told (said, wanted) && told (said, cases{k,2});
      end
      gsmbp_check (sprintf ("input function: %s", cases{k,2}), good);
    end
  end
  r = gsmbp_simulate (m, x0, [0, 0.1], "input", @(varargin) int8 (3));
  e = gsmbp_simulate (m, x0, [0, 0.1], "input", 3);
  gsmbp_check ("any number is a number", r.x - e.x, 1e-9);
end

function k = method_place (name)
  k = find (strcmp (name, {"dp853", "rk4", "cvode"}));
end

function v = ifelse_ (yes, f, t, x)
  v = 0;
  if (yes)
    v = f (t, x);
  end
end

## with an audit two more states are integrated: the function does not see them
function audited ()
  m = gsmbp_fixture ("saturated");
  n = [];
  seen = @(t, x) merge (numel (x) == m.sizes.nx, zeros (m.sizes.nv, 1), NaN (m.sizes.nv, 1));
  r = gsmbp_simulate (m, m.initial, [0, 0.01], "input", seen, "audit", 1);
  gsmbp_check ("a function sees the states of the scene alone", all (isfinite (r.x(:))));
end

function starts (m, c)
  told_of = @(x) gsmbp_complaint (@() gsmbp_simulate (m, x, [0, 0.1]));
  words = " (the states of motor_pendulum)";
  cases = {[0, 0, NaN], "argument x0(3), drive.i is not finite: NaN"; ...
           [0, -Inf, 0], "argument x0(2), q_d is not finite: -Inf"; ...
           [0, 0, 1e301], "argument x0(3), drive.i is too large (at most 1e300): 1e+301"; ...
           [1e16, 0, ...
            0], "argument x0(1), q: expected an angle of at most 1e15 rad, found 1e+16"; ...
           [0, 1i, 0], ["argument x0: expected 3 real numbers" words ", found complex ones"]; ...
           [0, 0], ["argument x0: expected 3 numbers" words ", found 1x2"]; ...
           ones(3, 3), ["argument x0: expected 3 numbers" words ", found 3x3"]; ...
           "abc", "argument x0: expected no text, found \"abc\"; options follow the arguments"; ...
           {0, 0, 0}, ["argument x0: expected 3 real numbers" words ", found cell"]; ...
           [0, 0, 1e300], "a rate of the states is not finite at t = 0 s; there q_d = 0 rad/s"; ...
           [0, 0, 1e100], "there q_d = 0 rad/s has the rate 6.25e+100 rad/s^2"};
  for k = 1:rows (cases)
    gsmbp_check (["start: " cases{k,2}], told (told_of (cases{k,1}), cases{k,2}));
  end
  x = gsmbp_assemble (c, c.initial);
  for size_ = 10 .^ [20, 50, 100, 150, 200, 300]
    x(4) = size_;
    said = gsmbp_complaint (@() gsmbp_simulate (c, x, [0, 0.1], "start", "project", ...
                                                "maxsteps", 1000));
    gsmbp_check (sprintf ("a crank at %g rad/s is an error", size_), told (said, "gsmbp_"));
  end
end

## a run that ends before its time says where, and which state it was
function ends (m)
  pull = @(t, x) 1e9 * exp (1e4 * (t - 0.05));
  for method = {"dp853", "rk4", "cvode"}
    said = gsmbp_complaint (@() gsmbp_simulate (m, [0; 0; 0], [0, 1], "input", pull, ...
                                                "method", method{1}));
    gsmbp_check ([method{1} ": what grows without bound ends in an error"], ...
                 told (said, " at t = "));
  end
end
