## [text, id] = gsmbp__failure (m, info, stats, said, last)
## Why a run of the model M, which has its parameters, ended: INFO of GSSIM, its statistics STATS
## (share/c/gsmbp/statistics.h), what its method SAID, and the LAST state, a
## struct with x and v (empty where there is none).  ID: that of an error that says so.

function [text, id] = gsmbp__failure (m, info, stats, said, last)
  id = "gsmbp:info";
  at = sprintf ("at t = %.9g s", stats.reached);
  switch (info)
    case 1
      text = ["more steps than option maxsteps allows, " at];
    case 2
      text = ["the step became too small " at ": a singularity, or too small a tolerance"];
    case 3
      if (stats.failed == 8 && stats.failed_info < 4)
        text = gsmbp__no_beginning (m, stats.reached, last, stats.failed_info);
        id = "gsmbp:start";
        return;
      elseif (stats.failed == 8)
        text = sprintf (["an event %s, where the constraints lose rank: no motion with the " ...
                         "speeds that it leaves was found, how it goes on is not determined"], at);
        return;
      endif
      routine = ...
          {"the inputs", "RHS", "PRJ", "CON", "the computation of the dependent coordinates", ...
                 "OUT or a sampled device", "an event"}{stats.failed};
      if (stats.failed == 7 && stats.cause > 0)
        routine = [routine ", " m.events(stats.cause).name ","];
      endif
      text = sprintf ("%s failed with INFO = %d %s: %s", routine, stats.failed_info, at,
                      cause (m, stats.failed, stats.failed_info));
    case 4
      text = ["the state is no longer finite " at ": take smaller steps"];
    case 6
      text = sprintf ("the method stopped %s with flag %d: %s", at, stats.cause, said);
    case 7
      text = "there was no memory for the method";
    case 8
      text = ["a rate of the states is not finite " at];
    case 9
      text = ["interrupted by Ctrl-C " at];
    case 10
      text = ["ended by option timeout " at];
    otherwise
      text = sprintf ("GSSIM: INFO = %d", info);
  endswitch
  if (info != 1 && stats.stiff)
    text = [text "; the steps are bound by stability"];
  endif
  text = [text, fastest(m, stats.reached, last, info), no_derivative(m, stats.reached, last, info)];
  if (! isempty (last))
    text = [text, gsmbp__outside(m, stats.reached, last.x, last.v)];
  endif
endfunction

## the sentence for INFO of the routine with that number (ISTAT(6), ISTAT(7) of GSSIM)
function text = cause (m, number, info)
  if (number == 7 && info == 9)
    text = "more than 100 events at one instant";
    if (any (strcmp ({m.events.kind}, "stick")))
      text = [text "; does friction fall within a speed vs below the tolerance of the speeds " ...
              "(atol)? remedy: a larger vs, or method \"dp853\""];
    endif
  elseif (number == 7 && info == 12)
    text = ["a reset gives a state a value that the loops do not leave it; expected resets of " ...
            "independent coordinates and speeds"];
  elseif (number == 7 && info == 10)
    text = ["an event comes faster and faster until its intervals are nothing beside the time " ...
            "(a reset that brings its expression back to zero); expected a rest, or a stop"];
  elseif (any (number == [2, 3]) && info == 9)
    text = ["the constraints lose rank here, where there are no derivatives by parameters " ...
            "(option sensitivity)"];
  elseif (any (number == [3, 5]) && info == 3)
    text = ...
        ["no position that closes the loops was found nearby; the mechanism may be at the end " ...
         "of its range"];
  elseif (number == 3 && info == 4)
    text = "no step leads away from a position where the constraints lose rank";
  else
    names = {"cmd", "rhs", "prj", "con", "prj", "out", "rst"};
    text = m.module ("meaning", names{number}, info);
  endif
endfunction

## the state that changes fastest beside its size, where the steps or the numbers gave out
function text = fastest (m, t, last, info)
  text = "";
  if (isempty (last) || ! any (info == [2, 4, 6, 8]) || ! any (strcmp (m.subroutines, "rhs")))
    return;
  endif
  [rate, ~] = m.rhs (t, last.x, last.v);
  share = abs (rate) ./ max (m.nominal, abs (last.x));
  share(! isfinite (share)) = Inf;
  [~, k] = max (share);
  unit = {m.units.states{k}, "1"}{1 + isempty(m.units.states{k})};
  per_second = regexprep ([unit "/s"], "/s/s$", "/s^2");
  text = sprintf ("; there %s = %.6g %s has the rate %.6g %s%s", m.states{k}, last.x(k), unit,
                  rate(k), per_second, gsmbp__nowhere (rate(k)));
endfunction

## the derivative that an implicit method lacks, where the rates are finite
function text = no_derivative (m, t, last, info)
  text = "";
  if (isempty (last) || info != 6 || ! any (strcmp (m.subroutines, "jac")))
    return;
  endif
  [rates, ~] = m.rhs (t, last.x, last.v);
  if (! all (isfinite (rates)))
    return;
  endif
  [A, ~, ~, ~, ~] = m.jac (t, last.x, last.v);
  text = gsmbp__not_finite (A, strcat ({"rate of "}, m.states(:)), m.states);
  text = [merge(isempty (text), "", "; "), text];
endfunction
