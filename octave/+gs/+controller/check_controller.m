## gs.controller.check_controller (who, c)
## An error of WHO where C is no controller that a computer can run.

function check_controller (who, c)
  if (isstruct (c) && isfield (c, "cst"))
    error (["%s: the controller %s (%s) calculates with the scene's INV: it is a part of the " ...
            "machine's own Fortran, expected one of gsmbp_control or gsmbp_pid"], who, c.name, ...
           c.method);
  endif
  needed = {"A", "B", "C", "D", "G", "period", "delay", "name", "measured", "references", ...
            "driven", "y0", "r0", "u0", "limits", "step_in", "step_out", "method"};
  if (! (isstruct (c) && isscalar (c) && all (isfield (c, needed))))
    error (["%s: expected a controller of gsmbp_control or gsmbp_pid (a struct with A, B, C, " ...
            "D, ...), found %s"], who, gs.text.shown_value (c));
  endif
  if (! (c.period > 0))
    error (["%s: the controller %s has no period: expected one for a computer, option " ...
            "\"period\" of gsmbp_control"], who, c.name);
  endif
  gs.controller.check_name (who, c);
endfunction
