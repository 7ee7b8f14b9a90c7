## tasks = gs.drive.task_motions (who, m, axes_, given)
## The motions that a machine is to make, a row of structs: name, plan, values (parameters that are
## other ones in this task, a load), and whether it ends at rest.

function tasks = task_motions (who, m, axes_, given)
  if (isstruct (given))
    given = {"motion", given};
  endif
  if (! (iscell (given) && ! isempty (given) && any (columns (given) == [2, 3]) ...
           && iscellstr (given(:,1))))
    error (["%s: motion: expected a plan of gsmbp_plan, or rows as {\"name\", plan} or " ...
            "{\"name\", plan, struct(\"m3\", 2)}, found %s"], who, gs.text.shown_value (given));
  endif
  n = numel (axes_);
  for i = 1:rows (given)
    one.name = given{i,1};
    one.plan = gs.given.given_polynomial (who, given{i,2}, n, ...
                                          sprintf ("motion %s (the coordinates %s)", one.name, ...
                                                       strjoin ({axes_.coordinate}, ", ")));
    one.values = struct ();
    if (columns (given) > 2)
      one.values = given{i,3};
    endif
    if (! (isstruct (one.values) && isscalar (one.values)))
      error ("%s: motion %s: expected a struct of parameter values, found %s", who, one.name, ...
             gs.text.shown_value (one.values));
    endif
    over = [one.plan.breaks(1), one.plan.breaks(end)];
    f = gsmbp_evaluate (one.plan, over(2), 1, -1);
    one.rests = max (abs (f(:,:,end))) <= 1e-9 * max (1, max (abs (f(:))));
    [one.start, one.stop] = deal (over(1), over(2));
    tasks(i) = one;
  endfor
endfunction
