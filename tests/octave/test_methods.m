## Every method of share/engine/core/gsmbp/methods.h on a motor with a pendulum, against dp853 at
#its least # tolerance: with fixed steps errors fall by the second order or faster, with controlled
#ones they # keep to the tolerance.

function test_methods ()
  m = gsmbp_hand ("motor_pendulum");
  rows = gs.text.table_rows ("GS_METHODS");
  truth = last_state (m, "dp853", {"rtol", 1e-14});
  for k = 1:size (rows, 1)
    row = gs.run.method_row (rows{k,1});
    if (strcmp (row.by, "library") && ! gsmbp_has_sundials ())
      continue;
    endif
    if (row.fixed)
      e = cellfun (@(h) norm (last_state (m, rows{k,1}, {"step", h}) - truth), {4e-3, 2e-3});
      gsmbp_check ([rows{k,1} ": half the step, a fourth of the error at most"], ...
                   e(2) <= max (e(1) / 3.5, 1e-11));
    else
      gsmbp_check ([rows{k,1} ": the tolerance"], ...
                   last_state (m, rows{k,1}, {"rtol", 1e-8}) - truth, 1e-5);
    endif
  endfor
endfunction

function x = last_state (m, method, options)
  r = gsmbp_simulate (m, [1 0 0], [0 0.5], "method", method, options{:});
  x = r.x(end,:);
endfunction
