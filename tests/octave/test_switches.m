## What switches at a time that is known beforehand: steps end there, in every method, against
## closed forms and an input with breaks; derivatives; ensembles whose times differ.

function test_switches ()
  m = gsmbp_fixture ("switch_circuit");
  gsmbp_check ("the times", sort (m.swi ()) - [0.1; 0.3; 0.7], 1e-16);
  from_the_right (m);
  every_method (m);
  by_parameters (m);
  many_runs (m);
  rows_at_switches (m);
  with_events (gsmbp_fixture ("switch_events"));
end

## events of the states behind a switch, and of an expression that switches, at its time
function with_events (m)
  half = 0.1 * log (2);
  exact = [half; 2*half; 0.15; 0.1+0.1*log(5/2)];
  for method = {"dp853", "rk4"}
    r = gsmbp_simulate (m, [0; 0], [0 0.05 0.2 0.5], "method", method{1}, "step", 1e-3, ...
                        "rtol", 1e-11);
    gsmbp_check (["events of a scene that switches by " method{1}], r.events.t - exact, 1e-9);
    gsmbp_check ("their names", isequal (r.events.name(:)', {"half", "half", "jump", "charged"}));
    gsmbp_check ("an event ends the run", r.x(end,1) - 3, 1e-9);
  end
end

## the voltage of the capacitor, tau its time constant
function u = closed_form (t, tau, vs, t1, d, t3)
  rise = @(t0) (t >= t0) .* (1 - exp (-max (0, t - t0) / tau));
  u = vs * (rise (t1) - rise (t1 + d) + 2 * rise (t3));
end

function from_the_right (m)
  at = [0.1 - eps(0.1), 0.1, 0.7 - eps(0.7), 0.7];
  rates = arrayfun (@(t) (m.rhs (t, [0; 0], 0))(1), at);
  gsmbp_check ("rates before and from a switch on", rates - [0 50 0 100], 1e-12);
  gsmbp_check ("an output that switches", m.out (0.09, [3; 0], 0) - 3, 0);
  gsmbp_check ("an output that has switched", m.out (0.11, [3; 0], 0) - 1, 0);
end

function every_method (m)
  t = linspace (0, 1, 41)';
  exact = closed_form (t, 0.1, 5, 0.1, 0.2, 0.7);
  voltage = mkpp ([0 0.1 0.3 0.7 1], [0; 5; 0; 10]);
  for method = {"dp853", "rk4", "radau", "gauss", "cvode", "auto"}
    r = gsmbp_simulate (m, [0; 0], t, "method", method{1}, "rtol", 1e-11, "step", 1e-3, ...
                        "input", voltage);
    gsmbp_check (["a voltage that switches by " method{1}], r.x(:,1) - exact, 1e-9);
    gsmbp_check (["as an input that jumps by " method{1}], diff (r.x, 1, 2), 1e-13);
    if (any (strcmp (method{1}, {"dp853", "radau"})))
      gsmbp_check (["steps do not collapse by " method{1}], ...
                   r.stats.accepted + r.stats.rejected < 100);
    end
  end
end

function by_parameters (m)
  t = linspace (0, 1, 11)';
  r = gsmbp_simulate (m, [0; 0], t, "sensitivity", {"r", "vs"});
  h = 1e-4;
  by_r = (closed_form (t, 0.1 + h/1000, 5, 0.1, 0.2, 0.7) ...
          - closed_form (t, 0.1 - h/1000, 5, 0.1, 0.2, 0.7)) / (2 * h);
  gsmbp_check ("derivatives by the voltage", r.dx.vs(:,1) - r.x(:,1) / 5, 1e-9);
  gsmbp_check ("derivatives by the resistance", r.dx.r(:,1) - by_r, 1e-8);
end

## a row at a time at which the scene switches is of one side: its outputs are from before, as its
## inputs and states; the first one is from behind
function rows_at_switches (m)
  t = [0 0.05 0.1 0.2 0.3];
  jump = mkpp ([0 0.1 1], [1; 2]);
  off = @(x, y) y - x(:,1) .* (t(:) <= 0.1) - (t(:) > 0.1);
  for method = {"dp853", "rk4", "radau", "gauss", "cvode"}
    o = {"method", method{1}, "step", 1e-3, "input", jump};
    r = gsmbp_simulate (m, [3; 0], t, o{:});
    gsmbp_check (["outputs of a row at a switch by " method{1}], off (r.x, r.y), 0);
    gsmbp_check (["inputs of it by " method{1}], r.v(3) - 1, 0);
  end
  for method = {"dp853", "rk4", "radau"}
    e = gsmbp_ensemble (m, [3; 0], t, "parameters", struct ("r", 100 * ones (20, 1)), ...
                        "method", method{1}, "step", 1e-3);
    gsmbp_check (["outputs of many runs at a switch by " method{1}], ...
                 off (e.x(:,:,1), e.y(:,1,1)), 0);
    gsmbp_check ("they are those of all", isequal (e.y, e.y(:,:,ones (1, 20))));
  end
  r = gsmbp_simulate (m, [3; 0], [0.1 0.2]);
  gsmbp_check ("the first row is from behind", r.y - 1, 0);
  r = gsmbp_simulate (m, [3; 0], t, "sensitivity", {"r"});
  gsmbp_check ("derivatives of outputs at a switch", r.dy.r - r.dx.r(:,1) .* (t(:) <= 0.1), 0);
end

## each run has times of its own, in lanes and one by one
function many_runs (m)
  t = linspace (0, 1, 21);
  t1 = [0.05; 0.1234; 0.4];
  d = [0.3; 0.01; 0.2];
  for method = {"dp853", "rk4", "radau"}
    e = gsmbp_ensemble (m, [0; 0], t, "parameters", struct ("t1", t1, "d", d), "step", 1e-3, ...
                        "method", method{1});
    for k = 1:3
      exact = closed_form (t', 0.1, 5, t1(k), d(k), 0.7);
      gsmbp_check (["a run with times of its own by " method{1}], e.x(:,1,k) - exact, 2e-9);
      one = gsmbp_simulate (gsmbp_set (m, "t1", t1(k), "d", d(k)), [0; 0], t, "step", 1e-3, ...
                            "method", method{1});
      gsmbp_check ("it is the single run", one.x - e.x(:,:,k), 1e-13);
    end
    turned = gsmbp_ensemble (m, [0; 0], t, "parameters", ...
                             struct ("t1", flipud (t1), "d", flipud (d)), "step", 1e-3, ...
                             "method", method{1});
    gsmbp_check ("the same bits in another order", isequal (turned.x, flip (e.x, 3)));
  end
end
