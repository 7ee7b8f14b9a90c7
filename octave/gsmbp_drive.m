## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {@var{r} =} gsmbp_drive (@var{cycle})
## @deftypefnx {} {@var{r} =} gsmbp_drive (@var{cycle}, @var{option}, @var{value}, @dots{})
## Choose a motor with a gear (or a screw) and an amplifier for a load cycle.
##
## Every pair of the catalogues is held against the @var{cycle} (of @code{gsmbp_cycle}), sample by
## sample.  With the ratio n, the efficiency eta where the motor drives the load (T*omega >= 0) and
## eta_back where the load drives it:
## @example
## Tm = (Jm + J_in)*n*alpha + bm*n*omega + Tc*sign(omega) + T/(n*eta)
## Tm = ... + T*eta_back/n              where T*omega < 0
## i = Tm/Kt,  V = R*i + Kb*n*omega     (the inductance is left out)
## @end example
## The limits, by the words in which a pair says what it breaks:
## @table @code
## @item T_peak, T_cont
## largest |Tm|, rms of Tm
## @item omega_max, voltage
## n*|omega|; |V| at every sample, the torque-speed line
## @item thermal
## Rth*R*(rms of i)^2 against dT_max (R is that of the warm winding)
## @item gear_peak, gear_cont, gear_speed
## |T|, rms of T, n*|omega|
## @item inertia
## load : motor, inertia/(n^2*(Jm + J_in)), where "inertia_ratio" is given
## @item buckling, critical_speed
## |T| against half of Euler's load of the screw, n*|omega| against 0.8 of its critical speed, where
## "support" is given
## @item amplifier_voltage, current_peak, current_cont
## |V|, |i|, rms of i, where amplifiers are given
## @end table
## Options: "motors", "gears", "amplifiers": lists of @code{gsmbp_catalogue} (default the typical
## data; no amplifiers); "screws": instead of gears, for an axis that slides (the default there),
## n = 2*pi/lead; "goal": "mass" (default), "energy" (of V*i over the cycle, what the load
## gives back is used), "energy_no_recovery", "cost", "power_peak" (|Tm*n*omega|) or
## "torque_rms"; "inertia_ratio": largest load : motor (default Inf); "support":
## @code{@{length, ends@}}, the unsupported length [m] of a screw and its ends, "fixed-free",
## "supported-supported", "fixed-supported" or "fixed-fixed", with which Euler's load and the
## critical speed of the screw (steel, by its root diameter d_root) are limits, too; "device": names
## of a motor and of a gear of a scene, for @code{parameters}.
##
## @var{r} has the fields
## @table @code
## @item pairs
## all of them, a struct array: @code{name}, @code{motor}, @code{gear}, @code{amplifier},
## @code{ratio}, @code{feasible}, @code{violated}, @code{utilization} of each limit (1: all of it),
## @code{torque_peak}, @code{torque_rms}, @code{speed_max}, @code{voltage_max},
## @code{current_peak}, @code{current_rms}, @code{temperature_rise}, @code{gear_torque_peak},
## @code{gear_torque_rms}, @code{inertia_ratio}, @code{power_peak}, @code{electric_power_peak},
## @code{energy}, @code{energy_no_recovery}, @code{mass}, @code{cost} (in SI units), @code{device}
## @item order
## numbers of the feasible ones, the best by the goal first, equal ones by name
## @item best
## the first of these (empty, with a warning, where there is none); @code{best.device} has the
## constants of the device dc_motor (R, L, K, J with the gear's, B, tc), @code{ratio} and
## @code{eta}, @code{best.parameters} the same by the names that a scene has for those of its
## devices dc_motor and lossy_gear (option "device"), for @code{gsmbp_set}
## @item motors
## for each motor, whatever the gears: @code{accelerating_factor} T_cont^2/Jm,
## @code{load_factor} 2*(alpha_rms*T_rms + mean(alpha*T)), whether it @code{suits} (the first is not
## below the second), @code{ratio}, that of least rms torque, @code{ratio_least} and
## @code{ratio_largest} that keep T_cont, @code{ratio_of_speed}, the largest by omega_max, and
## @code{said}, a sentence.  They hold without losses, friction and inertia of the gear.
## @end table
## Without a result the best ten and the sentence of the best motor are printed.
##
## @c session octave
## @example
## >> t = (0:0.01:1)';
## >> c = gsmbp_cycle ([t, 6*t.*(1-t), 6-12*t, 2*(6-12*t) + 10]);
## >> r = gsmbp_drive (c);
## >> r.best.name, numel (r.order), r.pairs(1).violated
## ans = S02+B049
## ans = 81
## ans =
## @{
##   [1,1] = T_peak
##   [1,2] = T_cont
##   [1,3] = voltage
##   [1,4] = thermal
## @}
## >> r.motors(3).said(1:68)
## ans = S03: least rms torque at the ratio n = sqrt (T_rms/(Jm*alpha_rms)) =
## @end example
##
## Errors: a cycle that is none of @code{gsmbp_cycle}; a catalogue that lacks a field; gears for an
## axis that slides, screws for one that turns; a limit of the inertia ratio where the cycle knows
## no inertia; an unknown goal.
## Source: Roos, Johansson and Wikander, Mechatronics 16 (2006); Giberti, Cinquemani and Legnani,
## Mechanism and Machine Theory 45 (2010).
## @seealso{gsmbp_cycle, gsmbp_catalogue, gsmbp_drive_plot, gsmbp_cylinder}
## @end deftypefn

function r = gsmbp_drive (cycle, varargin)
  if (nargin < 1)
    print_usage ();
  endif
  who = "gsmbp_drive";
  gs.given.refuse_words (who, "cycle", cycle);
  table = {"motors", [], "any"; "gears", [], "any"; "screws", [], "any"; "amplifiers", [], "any"
           "goal", "mass", {"mass", "energy", "energy_no_recovery", "cost", "power_peak", ...
                            "torque_rms"}
           "inertia_ratio", Inf, "positive"; "support", {}, "any"
           "device", {}, "names"};
  o = gs.given.call_options (who, table, varargin);
  check_cycle (who, cycle, o);
  [motors, gears, amplifiers] = lists_of (who, cycle, o);
  pairs = cell (1, 0);
  for motor = motors
    for gear = gears
      for k = 1:max (1, numel (amplifiers))
        pairs{end+1} = gs.drive.motor_and_gear (cycle, motor, gear, amplifiers(k:min (k, end)), ...
                                                o.inertia_ratio);
      endfor
    endfor
  endfor
  [r.cycle, r.goal, r.pairs] = deal (cycle, o.goal, [pairs{:}]);
  r.order = gs.drive.rank_choices (r.pairs, o.goal);
  r.motors = arrayfun (@(motor) gs.drive.best_ratio (cycle, motor), motors);
  [r.catalogues.motors, r.catalogues.gears] = deal (motors, gears);
  r.best = best_of (who, r, o);
  if (nargout == 0)
    tell (r);
    clear r;
  endif
endfunction

function check_cycle (who, c, o)
  gs.given.check_load_cycle (who, c);
  if (isfinite (o.inertia_ratio) && isnan (c.inertia))
    error (["%s: option inertia_ratio: the cycle knows no inertia; expected one of gsmbp_cycle " ...
            "(..., \"inertia\", value)"], who);
  elseif (strcmp (c.unit, "m") && ! isempty (o.gears))
    error ("%s: option gears: the axis slides; expected screws", who);
  elseif (strcmp (c.unit, "rad") && ! isempty (o.screws))
    error ("%s: option screws: the axis turns; expected gears", who);
  elseif (strcmp (c.unit, "rad") && ! isempty (o.support))
    error ("%s: option support: the axis turns; expected an axis that slides, with a screw", who);
  endif
endfunction

## motors, gears (screws as such), amplifiers
function [motors, gears, amplifiers] = lists_of (who, c, o)
  motors = gs.drive.given_parts (who, "motors", o.motors);
  if (strcmp (c.unit, "m"))
    support = gs.drive.screw_support (who, o.support);
    gears = arrayfun (@(s) as_gear (s, support), gs.drive.given_parts (who, "screws", o.screws));
  else
    gears = gs.drive.given_parts (who, "gears", o.gears);
    [gears.F_buckling, gears.omega_critical] = deal (Inf);
  endif
  amplifiers = [];
  if (! isempty (o.amplifiers))
    amplifiers = gs.drive.given_parts (who, "amplifiers", o.amplifiers);
  endif
endfunction

## a screw: a gear whose ratio is in rad/m
function g = as_gear (s, support)
  g = struct ("name", s.name, "ratio", 2 * pi / s.lead, "eta", s.eta, "eta_back", s.eta_back, ...
              "J_in", s.J, "T_cont", s.F_cont, "T_peak", s.F_peak, "omega_in_max", s.omega_max, ...
              "mass", s.mass, "cost", s.cost);
  [g.F_buckling, g.omega_critical] = gs.drive.screw_limits (s, support);
endfunction

function best = best_of (who, r, o)
  best = [];
  if (isempty (r.order))
    warning ("gsmbp:drive", "%s: none of the %d pairs keeps all limits; %s", who, ...
             numel (r.pairs), gs.drive.nearest_choice (r.pairs));
    return;
  endif
  best = r.pairs(r.order(1));
  best.parameters = named (devices_of (o.device), best.device);
endfunction

function list = devices_of (given)
  list = {};
  if (! isempty (given))
    list = cellstr (given);
  endif
endfunction

## the constants by the names of the parameters that a scene makes for devices; friction that does
## not depend on speed is that of the gear
function p = named (devices, d)
  p = struct ();
  if (numel (devices) > 0)
    p = struct ([devices{1} "_R"], d.R, [devices{1} "_L"], d.L, [devices{1} "_K"], d.K, ...
                [devices{1} "_J"], d.J, [devices{1} "_B"], d.B);
  endif
  if (numel (devices) > 1)
    p.([devices{1} "_J"]) = d.Jm;
    p.([devices{2} "_n"]) = d.ratio;
    p.([devices{2} "_ef"]) = d.eta;
    p.([devices{2} "_J"]) = d.J_in;
    if (d.tc > 0)
      p.([devices{2} "_Tc"]) = d.tc;
    endif
  endif
endfunction

function tell (r)
  units = struct ("mass", "kg", "energy", "J", "energy_no_recovery", "J", "cost", "", ...
                  "power_peak", "W", "torque_rms", "N*m");
  printf ("%d of %d pairs keep all limits; by %s:\n", numel (r.order), numel (r.pairs), r.goal);
  for k = r.order(1:min (10, end))
    p = r.pairs(k);
    [most, j] = max (cell2mat (struct2cell (p.utilization)));
    printf ("  %-16s %.5g %s; most used: %s, %.0f %%\n", p.name, p.(r.goal), ...
            units.(r.goal), fieldnames (p.utilization){j}, 100 * most);
  endfor
  if (! isempty (r.best))
    said = r.motors(strcmp ({r.motors.name}, r.best.motor)).said;
    printf ("%s\n", strrep (strrep (said, "; ", ";\n  "), " = sqrt (", "\n  = sqrt ("));
  endif
endfunction

%!function c = cycle ()
%! t = (0:0.01:1)';
%! c = gsmbp_cycle ([t, 6*t.*(1-t), 6-12*t, 2*(6-12*t) + 10], "inertia", 2);
%!endfunction
%!test <one pair by hand, the load drives the motor back>
%! warning ("off", "gsmbp:drive", "local");
%! m = struct ("name", "M", "R", 2, "L", 0, "Kt", 0.5, "Kb", 0.4, "Jm", 3, "bm", 0.1, "Tc", 0.2, ...
%!             "T_cont", 9, "T_peak", 9, "omega_max", 9, "V_max", 9, "Rth", 1, "dT_max", 9, ...
%!             "mass", 1, "cost", 2);
%! g = struct ("name", "G", "ratio", 10, "eta", 0.8, "eta_back", 0.5, "J_in", 1, "T_cont", 99, ...
%!             "T_peak", 99, "omega_in_max", 99, "mass", 4, "cost", 8);
%! c = gsmbp_cycle ([0 1 2 40; 1 1 2 -40], "inertia", 800);
%! p = gsmbp_drive (c, "motors", m, "gears", g, "inertia_ratio", 3);
%! p = p.pairs;
%! T = 4*10*2 + 0.1*10 + 0.2 + [40/8; -40*0.5/10];
%! i = T / 0.5;
%! v = 2*i + 4;
%! assert ([p.torque_peak, p.torque_rms, p.voltage_max], [T(1), sqrt(mean(T.^2)), v(1)], 1e-12);
%! assert ([p.energy, p.inertia_ratio, p.mass, p.cost], [mean(v.*i), 2, 5, 10], 1e-10);
%! assert (p.temperature_rise, 2 * mean (i .^ 2), 1e-9);
%! assert (p.violated, {"T_peak", "T_cont", "omega_max", "voltage", "thermal"});
%!test <the ratio of the formula has the least rms torque>
%! warning ("off", "gsmbp:drive", "local");
%! c = cycle ();
%! m = gsmbp_catalogue ("motors")(3);
%! [m.bm, m.Tc] = deal (0);
%! g = gsmbp_catalogue ("gears")(1);
%! r = gsmbp_drive (c, "motors", m);
%! n = r.motors.ratio * [0.999, 1, 1.001];
%! for k = 1:3
%!   g.ratio = n(k);
%!   T(k) = gsmbp_drive (c, "motors", m, "gears", g).pairs.torque_rms;
%! endfor
%! assert (T(2) < min (T([1 3])) && T(2) > min (T([1 3])) * (1 - 1e-5));
%! for n = [r.motors.ratio_least, r.motors.ratio_largest]
%!   g.ratio = n;
%!   assert (gsmbp_drive (c, "motors", m, "gears", g).pairs.torque_rms, m.T_cont, 1e-12);
%! endfor
%!test <an accelerating factor just below the load factor: no ratio; just above: one>
%! c = cycle ();
%! m = gsmbp_catalogue ("motors")(3);
%! factor = gsmbp_drive (c, "motors", m).motors.load_factor;
%! warning ("off", "gsmbp:drive", "local");
%! m.T_cont = sqrt (factor * m.Jm) * (1 - 1e-9);
%! f = gsmbp_drive (c, "motors", m).motors;
%! assert (! f.suits && isnan (f.ratio_least) && any (strfind (f.said, "no ratio keeps T_cont")));
%! m.T_cont = sqrt (factor * m.Jm) * (1 + 1e-9);
%! f = gsmbp_drive (c, "motors", m).motors;
%! assert ([f.ratio_least, f.ratio_largest], [f.ratio, f.ratio], 1e-3 * f.ratio);
%!test <equal figures: by name>
%! m = gsmbp_catalogue ("motors")([5 5]);
%! [m.name] = deal ("b", "a");
%! g = gsmbp_catalogue ("gears")(11);
%! assert ({gsmbp_drive(cycle (), "motors", m, "gears", g).pairs(2).name, ...
%!          gsmbp_drive(cycle (), "motors", m, "gears", g).best.name}, {"a+B016", "a+B016"});
%!test <amplifiers; names of parameters>
%! warning ("off", "gsmbp:drive", "local");
%! a = gsmbp_catalogue ("amplifiers");
%! r = gsmbp_drive (cycle (), "amplifiers", a, "device", {"M", "G"});
%! assert (numel (r.pairs), 8 * 22 * 8);
%! assert (fieldnames (r.best.parameters)', {"M_R", "M_L", "M_K", "M_J", "M_B", "G_n", ...
%!                                               "G_ef", "G_J", "G_Tc"});
%! a(1).V_max = 0.1;
%! p = gsmbp_drive (cycle (), "amplifiers", a(1)).pairs;
%! assert (all (cellfun (@(v) any (strcmp (v, "amplifier_voltage")), {p.violated})));
%!test <a screw that locks itself is driven down, too>
%! warning ("off", "gsmbp:drive", "local");
%! c = gsmbp_cycle ([0 -0.01 0 800; 1 -0.01 0 800], "unit", "m");
%! s = gsmbp_catalogue ("screws");
%! r = gsmbp_drive (c, "screws", s(end-1));
%! m = gsmbp_catalogue ("motors")(1);
%! n = 2 * pi / s(end-1).lead;
%! assert (s(end-1).eta_back < 0);
%! assert (r.pairs(1).torque_rms, m.bm * n * 0.01 + m.Tc - s(end-1).eta_back * 800 / n, 1e-15);
%!warning <none of the 176 pairs keeps all limits; .* is nearest \(>
%! r = gsmbp_drive (gsmbp_cycle ([0 10 0 9e4; 1 10 0 9e4]));
%!error <option gears: the axis slides; expected screws>
%! gsmbp_drive (gsmbp_cycle ([0 1 1 1; 1 1 1 1], "unit", "m"), "gears", 1)
%!error <option screws: the axis turns; expected gears>
%! gsmbp_drive (cycle (), "screws", gsmbp_catalogue ("screws"))
%!error <the cycle knows no inertia>
%! gsmbp_drive (gsmbp_cycle ([0 1 1 1; 1 1 1 1]), "inertia_ratio", 5)
%!error <option motors: expected a list of gsmbp_catalogue \("motors"\) with the fields name, R>
%! gsmbp_drive (cycle (), "motors", struct ("name", "a"))
%!error <expected a struct of gsmbp_cycle, found 3> gsmbp_drive (3)
%!error <argument cycle: torque: expected a column of finite numbers>
%! gsmbp_drive (setfield (cycle (), "torque", NaN (101, 1)))
%!error <option goal: expected one of "mass", "energy"> gsmbp_drive (cycle (), "goal", "weight")
