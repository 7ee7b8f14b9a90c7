## Optimal motions of scenes without outputs, inputs or parameters, and with an input that stays at
## zero: closed forms of a double integrator and of an oscillator. Designs of controllers for a
## scene without inputs.

function test_collocate_bare ()
  idle (gsmbp_fixture ("idle_slide"));
  m = gsmbp_fixture ("still_slide");
  no_inputs (m);
  no_controller (m);
end

## int F^2 from rest to rest over s = 1 m in T = 1 s is 12*m^2*s^2/T^3; the least time with |F| <= 2
## is 2*sqrt (m*s/F); a constant force moves the mass by F*T^2/(2*m)
function idle (m)
  ends = {[0 0 0 0], [1 0 0 0]};
  square = {"F1^2", 1, "F2^2", 1};
  least (m, "an input that stays at zero", 12, ends, "goal", square, "time", 1);
  least (m, "... whose bounds are zero", 12, ends, "goal", square, "time", 1, "inputs", ...
         {"F2", 0, 0});
  least (m, "... without smoothing", 12, ends, "goal", square, "time", 1, "inputs", ...
         {"F2", 0, 0}, "regularize", 0);
  least (m, "... that is not in the goal", 12, ends, "goal", "F1^2", "time", 1);
  least (m, "... the least time", sqrt (2), ends, "time", [0.1 10], "inputs", {"F1", -2, 2});
  least (m, "all inputs stay at zero", 0, {[0 0 0 0], [0 0 0 0]}, "goal", square, "time", 1);
  r = least (m, "an input that is fixed at 2 N", 4, {[0 0 0 0], [NaN 0 NaN 0]}, "goal", square, ...
             "time", 1, "inputs", {"F1", 2, 2});
  gsmbp_check ("... moves 1 kg by 1 m", r.x(end,1) - 1, 1e-9);
end

function r = least (m, said, goal, ends, varargin)
  r = gsmbp_collocate (m, ends{:}, varargin{:});
  gsmbp_check (sprintf ("%s: solved, the goal is %.9g", said, r.goal), ...
               r.solved && abs (r.goal - goal) < 1e-6);
  gsmbp_check ([said ": all weights of roughness are finite"], ...
               all (isfinite ([r.singular.weight])));
end

## s = cos (2*t): int s^2 dt from 0 to 1 is 1/2 + sin (4)/8
function no_inputs (m)
  r = gsmbp_collocate (m, [1 0], [NaN NaN], "time", 1, "goal", "s^2");
  gsmbp_check (sprintf ("no inputs: the integral of s^2 is %.9g", r.goal), ...
               abs (r.goal - (1/2 + sin (4)/8)) < 1e-8);
  gsmbp_check ("no inputs: the state at the end", r.x(end,:) - [cos(2), -2*sin(2)], 1e-6);
  gsmbp_check ("no inputs: no piecewise polynomial of inputs", isempty (r.input));
end

function no_controller (m)
  says = @(f) gsmbp_check ("a controller without inputs", any (strfind (gsmbp_complaint (f), ...
                           "argument m: expected a model with inputs; found none")));
  e = gsmbp_trim (m, [0; 0], []);
  says (@() gsmbp_control (m, e, "place", "poles", [-1 -2]));
  says (@() gsmbp_control (m, e, "lqr", "Q", 1, "R", 1));
  says (@() gsmbp_pid (m, e, "pd", "ms", 1.6));
  says (@() gsmbp_lqr (m, gsmbp_plan ("quintic", [0 1], [0 1]), [0 1], eye (2), []));
end
