## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {} gsmbp_drive_plot (@var{file}, @var{r})
## @deftypefnx {} {} gsmbp_drive_plot (@var{file}, @var{r}, "plane", @var{pair})
## @deftypefnx {} {} gsmbp_drive_plot (@var{file}, @var{r}, "motors")
## Draw the choice of a drive: @var{r} of @code{gsmbp_drive}; @var{file} as of @code{gsmbp_plot},
## with the numbers in the .csv beside it.
##
## @code{"plane"} (default): the torque-speed plane of a pair (its name, its number in
## @code{r.pairs}; default the best).  Over the motor's speed |n*omega| stands the torque times the
## sign of the speed, above 0 where the motor drives: the cycle; its rms torque; T_peak and T_cont
## up to omega_max; what V_max gives at each speed, the line (V_max - Kb*|n*omega|)*Kt/R, and below
## 0 the same with V_max + Kb*|n*omega|.
##
## @code{"motors"}: for each motor of the list the accelerating factor beside the load factor of the
## cycle (a motor below it cannot move the load with any ratio), and below the ratio of least rms
## torque, the ratios that keep T_cont and the largest that omega_max allows.
##
## @c session octave
## @example
## >> t = (0:0.01:1)';
## >> r = gsmbp_drive (gsmbp_cycle ([t, 6*t.*(1-t), 6-12*t, 2*(6-12*t) + 10]));
## >> gsmbp_drive_plot ("plane.png", r);
## >> gsmbp_drive_plot ("motors.png", r, "motors");
## @end example
##
## Errors: no result of gsmbp_drive; a pair that is not in it; no best pair.
## Source: own; Roos, Johansson and Wikander (2006), Giberti, Cinquemani and Legnani (2010).
## @seealso{gsmbp_drive, gsmbp_plot}
## @end deftypefn

function gsmbp_drive_plot (file, r, kind = "plane", pair = [])
  if (nargin < 2)
    print_usage ();
  endif
  who = "gsmbp_drive_plot";
  if (! (isstruct (r) && isscalar (r) && all (isfield (r, {"pairs", "motors", "catalogues"}))))
    error ("%s: argument r: expected a result of gsmbp_drive, found %s", who, ...
           gs.text.shown_value (r));
  endif
  gs.given.check_kind (who, "argument kind", kind, {"plane", "motors"});
  if (strcmp (kind, "motors"))
    motors (file, r);
  else
    plane (file, r, chosen (who, r, pair));
  endif
endfunction

function k = chosen (who, r, pair)
  k = pair;
  if (isempty (pair))
    if (isempty (r.order))
      error ("%s: no pair keeps all limits; expected the name of one to draw", who);
    endif
    k = r.order(1);
  elseif (ischar (pair))
    k = find (strcmp ({r.pairs.name}, pair), 1);
  endif
  if (isempty (k) || ! (isnumeric (k) && isscalar (k) && any (k == 1:numel (r.pairs))))
    error ("%s: argument pair: expected a name in r.pairs or a number from 1 to %d, found %s", who,
           numel (r.pairs), gs.text.shown_value (pair));
  endif
endfunction

function plane (file, r, k)
  c = r.cycle;
  p = r.pairs(k);
  m = r.catalogues.motors(strcmp ({r.catalogues.motors.name}, p.motor));
  g = r.catalogues.gears(strcmp ({r.catalogues.gears.name}, p.gear));
  T = gs.drive.motor_torque (c, m, g);
  w = p.ratio * c.omega;
  side = sign (w) + (w == 0);
  grid = linspace (0, m.omega_max, 200)';
  high = min (m.T_peak, max (m.Kt * (m.V_max - m.Kb * grid) / m.R, 0));
  low = max (-m.T_peak, -m.Kt * (m.V_max + m.Kb * grid) / m.R);
  round = [grid; flipud(grid)];
  curves = {[abs(w); NaN], [side .* T; NaN]
            [round; NaN], [high; flipud(low); NaN]
            [0; m.omega_max * [1; 1]; 0; NaN], [m.T_cont * [1; 1; -1; -1]; NaN]
            [0; p.speed_max], p.torque_rms * [1; 1]};
  names = {"cycle", "T_peak, voltage, omega_max", "T_cont", "rms of the cycle"};
  stacked (file, curves, names, "speed |n omega| [rad/s]", ...
           "torque in direction of speed [N m]", sprintf ("%s, ratio %.5g", p.name, p.ratio));
endfunction

## curves over abscissas of their own, one below the other in one table
function stacked (file, curves, names, xlabel, label, title)
  x = vertcat (curves{:,1});
  y = NaN (numel (x), rows (curves));
  last = 0;
  for k = 1:rows (curves)
    at = last + (1:numel (curves{k,1}));
    y(at,k) = curves{k,2};
    last = at(end);
  endfor
  there = ! isnan (x);
  x(! there) = max (x(there));
  gsmbp_plot (file, x, struct ("y", y, "names", {names}, "label", label), "xlabel", xlabel, ...
              "head", xlabel, "title", title, "size", [16, 10.5]);
endfunction

function motors (file, r)
  n = (1:numel (r.motors))';
  f = r.motors;
  first = struct ("y", [[f.accelerating_factor]', [f.load_factor]'], "names", ...
                  {{"accelerating factor T_cont^2/Jm", "load factor of the cycle"}}, ...
                  "label", "factor [W/s]", "style", "linespoints");
  second = struct ("y", [[f.ratio]', [f.ratio_least]', [f.ratio_largest]', [f.ratio_of_speed]'], ...
                   "names", {{"of least rms torque", "least that keeps T_cont", ...
                              "largest that keeps T_cont", "largest by omega_max"}}, ...
                   "label", "ratio n", "style", "linespoints");
  if (strcmp (r.cycle.unit, "m"))
    second.label = "ratio 2 pi/lead [rad/m]";
  endif
  gsmbp_plot (file, n, first, second, "scale", "semilogy", "head", "motor", "xlabel", ...
              sprintf ("number of the motor, 1 %s to %d %s", f(1).name, numel (f), f(end).name));
endfunction

%!test
%! if (isempty (file_in_path (getenv ("PATH"), "gnuplot")))
%!   return;
%! endif
%! file = [tempname() ".png"];
%! t = (0:0.01:1)';
%! r = gsmbp_drive (gsmbp_cycle ([t, 6*t.*(1-t), 6-12*t, 2*(6-12*t) + 10]));
%! unwind_protect
%!   gsmbp_drive_plot (file, r);
%!   table = dlmread ([file(1:end-3) "csv"], ",", 1, 0);
%!   assert (max (abs (table(1:101,2))), r.best.torque_peak, 1e-12);
%!   gsmbp_drive_plot (file, r, "plane", "S05+B007");
%!   table = dlmread ([file(1:end-3) "csv"], ",", 1, 0);
%!   m = gsmbp_catalogue ("motors")(5);
%!   voltage = m.R * table(103:302,3) / m.Kt + m.Kb * table(103:302,1);
%!   assert (max (voltage) <= m.V_max * (1 + 1e-12) && max (table(103:302,3)) == m.T_peak);
%!   gsmbp_drive_plot (file, r, "motors");
%!   assert (stat (file).size > 3000);
%! unwind_protect_cleanup
%!   delete (file);
%!   delete ([file(1:end-3) "csv"]);
%! end_unwind_protect
%!error <expected a result of gsmbp_drive, found 3> gsmbp_drive_plot ("a.png", 3)
%!test
%! t = (0:0.5:1)';
%! r = gsmbp_drive (gsmbp_cycle ([t, 6*t.*(1-t), 6-12*t, 2*(6-12*t) + 10]));
%! fail ('gsmbp_drive_plot ("a.png", r, "plane", "S09+B007")', ...
%!       "expected a name in r.pairs or a number from 1 to 176, found \"S09");
