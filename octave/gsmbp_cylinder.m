## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {@var{r} =} gsmbp_cylinder (@var{cycle}, "supply", @var{p}, @dots{})
## Choose a cylinder for the load cycle of a slide.
##
## @var{cycle} of @code{gsmbp_cycle} with the unit m and positions: along it the cylinder pushes the
## load with the force (pulls, where it is negative).  Every cylinder of the list is held against
## it, sample by sample, with A1 = pi*D^2/4, A2 = pi*(D^2 - d^2)/4.  The limits, by the words in
## which a cylinder says what it breaks:
## @table @code
## @item stroke
## the way between the extreme positions
## @item pressure
## "supply" against p_max
## @item force
## the supply moves the load: p = (force + back*A)/A' at most "supply", where "back" is the
## pressure of the return, A' the area that is fed (A1 outwards, A2 inwards), A the other one
## @item speed
## |speed| against v_max
## @item flow
## the flow A'*|speed|, where "flow" is given (that of the pump)
## @item valve
## A'*|speed| at most rated*sqrt((supply - p)/drop): what a valve edge that passes the flow
## "rated" at the pressure drop "drop" feeds at the pressure p that the load leaves, where "rated"
## is given
## @item buckling
## the largest push against pi^2*E*I/(ends*length)^2/safety of the rod, where d > 0; length is that
## of the rod, the stroke and "dead"
## @end table
## Options: "cylinders": a list of @code{gsmbp_catalogue} (default the typical data); "supply"
## [Pa], must be given; "back" [Pa] (default 0); "flow", "rated" [m^3/s]; "drop" [Pa] (default
## 35e5, of one edge); "goal": "mass" (default), "cost", "energy" (supply times the volume that
## is fed) or "flow_peak"; "ends" (default 1, both ends hinged), "safety" (default 3.5),
## "dead" [m] (default 0), "E" [Pa] (default 2.1e11).
##
## @var{r}: @code{cylinders}, a struct array (@code{name}, @code{feasible}, @code{violated},
## @code{utilization}, @code{pressure_peak}, @code{flow_peak}, @code{volume}, @code{energy},
## @code{mass}, @code{cost}, @code{A1}, @code{A2}); @code{order}, the feasible ones by the goal,
## equal ones by name; @code{best} (empty, with a warning, where there is none).
##
## @c session octave
## @example
## >> t = (0:0.01:2)';
## >> s = 0.15 * (1 - cos (pi * t)); v = 0.15 * pi * sin (pi * t);
## >> a = 0.15 * pi^2 * cos (pi * t);
## >> c = gsmbp_cycle ([t, v, a, 400*a + 6000], "unit", "m", "position", s);
## >> r = gsmbp_cylinder (c, "supply", 160e5, "rated", 1e-3);
## >> r.best.name, r.cylinders(2).violated
## ans = h32x500
## ans =
## @{
##   [1,1] = buckling
## @}
## @end example
##
## Errors: a cycle of an axis that turns or without positions; no supply; a catalogue that lacks a
## field.
## Source: Merritt, Hydraulic Control Systems (valve); Euler (buckling).
## @seealso{gsmbp_cycle, gsmbp_catalogue, gsmbp_drive}
## @end deftypefn

function r = gsmbp_cylinder (cycle, varargin)
  if (nargin < 1)
    print_usage ();
  endif
  who = "gsmbp_cylinder";
  gs.given.refuse_words (who, "cycle", cycle);
  table = {"cylinders", [], "any"
           "supply", [], "positive"; "back", 0, "nonnegative"
           "flow", Inf, "positive"; "rated", Inf, "positive"; "drop", 35e5, "positive"
           "goal", "mass", {"mass", "cost", "energy", "flow_peak"}
           "ends", 1, "positive"; "safety", 3.5, "positive"; "dead", 0, "nonnegative"
           "E", 2.1e11, "positive"};
  o = gs.given.call_options (who, table, varargin);
  if (isempty (o.supply))
    error ("%s: expected the option supply, the pressure [Pa], found none", who);
  endif
  check_cycle (who, cycle);
  list = gs.drive.given_parts (who, "cylinders", o.cylinders);
  found = arrayfun (@(one) held (cycle, one, o), list);
  r.goal = o.goal;
  r.cylinders = found;
  r.order = gs.drive.rank_choices (found, o.goal);
  r.best = [];
  if (isempty (r.order))
    warning ("gsmbp:drive", "%s: none of the %d cylinders keeps all limits; %s", who, ...
             numel (found), gs.drive.nearest_choice (found));
  else
    r.best = found(r.order(1));
  endif
endfunction

function check_cycle (who, c)
  gs.given.check_load_cycle (who, c);
  if (! strcmp (c.unit, "m"))
    error ("%s: the axis turns; expected a cycle of one that slides", who);
  elseif (any (isnan (c.position)))
    error ("%s: expected a cycle with positions (option position of gsmbp_cycle), found none", who);
  endif
endfunction

function p = held (c, one, o)
  [p.name, p.feasible, p.violated] = deal (one.name, true, {});
  p.A1 = pi * one.D ^ 2 / 4;
  p.A2 = p.A1 - pi * one.d ^ 2 / 4;
  out = c.omega > 0 | (c.omega == 0 & c.torque >= 0);
  fed = p.A2 + (p.A1 - p.A2) * out;
  other = p.A1 + p.A2 - fed;
  need = (c.torque .* (2 * out - 1) + o.back * other) ./ fed;
  flow = fed .* abs (c.omega);
  p.pressure_peak = max (need);
  p.flow_peak = max (flow);
  p.volume = trapz (c.t, flow);
  p.energy = o.supply * p.volume;
  [p.mass, p.cost] = deal (one.mass, one.cost);
  use = {"stroke", (max(c.position) - min(c.position)) / one.stroke
         "pressure", o.supply / one.p_max
         "force", max(p.pressure_peak / o.supply, 0)
         "speed", max(abs (c.omega)) / one.v_max
         "flow", p.flow_peak / o.flow
         "valve", valve_use(flow, o.supply - need, o)
         "buckling", buckling_use(c, one, o)};
  p.violated = use(! ([use{:,2}] <= 1),1)';
  p.feasible = isempty (p.violated);
  p.utilization = cell2struct (use(:,2), use(:,1), 1);
endfunction

## largest flow over what the valve feeds at the pressure that is left
function u = valve_use (flow, left, o)
  u = 0;
  if (isfinite (o.rated))
    u = max (flow ./ (o.rated * sqrt (max (left, 0) / o.drop)));
    if (any (left <= 0 & flow > 0))
      u = Inf;
    endif
  endif
endfunction

function u = buckling_use (c, one, o)
  inertia = pi * one.d ^ 4 / 64;
  critical = pi ^ 2 * o.E * inertia / (o.ends * (one.stroke + o.dead)) ^ 2;
  u = max (max (c.torque), 0) * o.safety / critical;
  if (one.d == 0)
    u = 0;
  endif
endfunction

%!function c = cycle ()
%! t = (0:0.01:2)';
%! c = gsmbp_cycle ([t, 0.15*pi*sin(pi*t), 0*t, 6000 + 0*t], "unit", "m", "position", ...
%!                  0.15 * (1 - cos (pi * t)));
%!endfunction
%!test <by hand: areas, pressures, the valve, buckling>
%! one = gsmbp_catalogue ("cylinders")(6);
%! r = gsmbp_cylinder (cycle (), "cylinders", one, "supply", 100e5, "back", 5e5, "rated", 1e-3, ...
%!                     "ends", 2);
%! p = r.cylinders;
%! A1 = pi * 0.04 ^ 2 / 4;
%! A2 = A1 - pi * 0.022 ^ 2 / 4;
%! need = (6000 + 5e5 * A2) / A1;
%! assert ([p.pressure_peak, p.flow_peak, p.volume], [need, A1*0.15*pi, (A1+A2)*0.3], 1e-3 * need);
%! assert (p.utilization.valve, A1*0.15*pi / (1e-3 * sqrt ((100e5 - need) / 35e5)), 1e-12);
%! F = pi^3 * 2.1e11 * 0.022^4 / 64 / (2 * 0.5)^2;
%! assert (p.utilization.buckling, 6000 * 3.5 / F, 1e-12);
%! assert (p.utilization.stroke, 0.3 / 0.5, 1e-12);
%!test <the choice is that of a search>
%! for goal = {"mass", "cost", "energy", "flow_peak"}
%!   r = gsmbp_cylinder (cycle (), "supply", 160e5, "rated", 2e-3, "goal", goal{1});
%!   ok = r.cylinders([r.cylinders.feasible]);
%!   assert (r.best.(goal{1}), min ([ok.(goal{1})]));
%! endfor
%!test <not enough pressure for the flow: infinitely more than the valve feeds>
%! warning ("off", "gsmbp:drive", "local");
%! r = gsmbp_cylinder (cycle (), "supply", 10e5, "rated", 1e-3);
%! assert (r.best, []);
%! assert (r.cylinders(1).violated, {"stroke", "force", "valve"});
%!warning <none of the 22 cylinders keeps all limits; .* is nearest>
%! r = gsmbp_cylinder (cycle (), "supply", 1e5);
%!error <expected the option supply> gsmbp_cylinder (cycle ())
%!error <the axis turns> gsmbp_cylinder (gsmbp_cycle ([0 1 1 1; 1 1 1 1]), "supply", 1)
%!error <expected a cycle with positions>
%! gsmbp_cylinder (gsmbp_cycle ([0 1 1 1; 1 1 1 1], "unit", "m"), "supply", 1)
%!error <option cylinders: expected a list of gsmbp_catalogue>
%! gsmbp_cylinder (cycle (), "supply", 1, "cylinders", 3)
