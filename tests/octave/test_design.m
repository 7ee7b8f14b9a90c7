## gsmbp_design against what the same steps give by hand: the drive by search through all pairs, the
## margins by runs at all corners, the spring by its formula; what is not met is said.

function test_design ()
  warning ("off", "gsmbp:design", "local");
  if (isempty (which ("ss")))
    pkg load control
  end
  m = gsmbp_fixture ("design_lifter");
  s = struct ("motion", gsmbp_plan ("quintic", [-1 0.5], [0 0.4]), "accuracy", 2e-3, ...
              "supply", 40, "goal", "energy", "inertia_ratio", 8, "reserve", 0.1, ...
              "period", 2e-3, "delay", 1e-3, "encoder", 1e-4);
  s.springs = {"k", [0 2000]};
  s.tolerances = {"ml", 0.1; "motor_K", 0.05};
  s.yield = 4;
  s.file = [tempname() ".html"];
  tidy = onCleanup (@() unlink (s.file));
  r = gsmbp_design (m, s);
  gsmbp_check ("all demands are met", double (! r.met), 0);
  the_drive (m, s, r);
  the_spring (m, r);
  the_corners (s, r);
  the_derivatives (r);
  the_page (r, fileread (s.file));
  the_yield (r, fileread (s.file));
  s.yield = 0;
  what_is_not_met (m, s);
  refusals (m, s);
end

## the pair of the least energy that leaves the reserve of all limits, by formulas of the help of
## gsmbp_drive
function the_drive (m, s, r)
  c = r.cycles;
  best = struct ("energy", Inf, "name", "");
  for a = gsmbp_catalogue ("motors")
    for b = gsmbp_catalogue ("gears")
      n = b.ratio;
      share = [1/b.eta, b.eta_back](1 + (c.torque .* c.omega < 0))(:);
      T = (a.Jm + b.J_in)*n*c.alpha + a.bm*n*c.omega + a.Tc*sign (c.omega) + c.torque/n .* share;
      rms = @(x) sqrt (trapz (c.t, x.^2)/(c.t(end) - c.t(1)));
      used = [max(abs (T))/a.T_peak, rms(T)/a.T_cont, n*max(abs (c.omega))/a.omega_max, ...
              max(abs (a.R*T/a.Kt + a.Kb*n*c.omega))/min(a.V_max, s.supply), ...
              a.Rth*a.R*rms(T/a.Kt)^2/a.dT_max, max(abs (c.torque))/b.T_peak, ...
              rms(c.torque)/b.T_cont, n*max(abs (c.omega))/b.omega_in_max, ...
              c.inertia/(n^2*(a.Jm + b.J_in))/s.inertia_ratio];
      i = T/a.Kt;
      energy = trapz (c.t, (a.R*i + a.Kb*n*c.omega) .* i);
      if (max (used) <= 1 - s.reserve && energy < best.energy)
        best = struct ("energy", energy, "name", [a.name "+" b.name]);
      end
    end
  end
  first = r.drives.pairs(r.drives.order(1));
  gsmbp_check (["the search finds " best.name], double (! strcmp (first.name, best.name)), 0);
  gsmbp_check ("and gsmbp_design takes it or says why not", ...
               double (! any (strcmp (best.name, {r.attempts.name}))), 0);
  gsmbp_check ("its ratio is that of the machine", r.machine.par.gear_n - r.best{1}.ratio, 0);
end

## the spring without a free length carries the weight everywhere: k*0.3*0.1 = ml*g*lc
function the_spring (m, r)
  gsmbp_check ("the spring", r.model.par.k / (5*9.81*0.3/(0.3*0.1)) - 1, 1e-6);
end

## the first point of Sobol is the middle: the nominal machine; the corners are the worst
function the_yield (r, page)
  used = [r.margins.used];
  worst = [r.margins.worst] ./ [r.margins.limit];
  y = r.yield;
  gsmbp_check ("yield: four machines, all of them within the corners that are met", ...
               y.runs == 4 && y.met == 4 && y.share == 1 && y.between(1) < 1);
  gsmbp_check ("none uses less than the nominal one at its most, none more than the corners", ...
               all ([y.measures.worst] > used - 1e-6 & [y.measures.worst] < 1.02 * worst + 1e-6));
  gsmbp_check ("the page tells the yield", ...
               ! isempty (strfind (page, "a yield of 100.0 %, 95 % interval 51.0 to 100.0 %")));
end

## runs at all four corners by hand: what was found at those that were chosen is the worst
function the_corners (s, r)
  ref = r.references{1};
  table = zeros (numel (ref.t), r.machine.sizes.nv);
  table(:,strcmp (r.machine.inputs, "ctl.angle_ref")) = ref.planned;
  fed = strcmp (r.machine.inputs, "ctl.motor_ff");
  if (any (fed))
    table(:,fed) = ref.voltages;
  end
  v = gsmbp_plan ("table", ref.t, table, 1);
  k = 0;
  for a = [0.9 1.1]
    for b = [0.95 1.05]
      values = struct ("ml", a*r.model.par.ml, "motor_K", b*r.model.par.motor_K);
      mc = gsmbp_set (r.machine, values);
      x0 = gsmbp_inverse (gsmbp_set (r.model, values), s.motion, 0).x(1,:);
      run = gsmbp_simulate (mc, x0, ref.t, "input", v, "rtol", 1e-8);
      k += 1;
      found(k,:) = [max(abs (run.x(:,1) - ref.planned)), max(abs (run.x(:,3)))*mc.par.motor_K];
    end
  end
  for i = 1:2
    o = r.margins(i);
    gsmbp_check (["the worst " o.name], o.worst / max (found(:,i)) - 1, 1e-9);
    ## derivatives do not know the steps of the encoder
    gsmbp_check (["to first order: " o.name], o.first - o.worst, 0.03*o.worst + i*1e-4);
  end
end

## derivatives through the joined controller, limits among what it meets, against differences
function the_derivatives (r)
  gsmbp_check ("carried with the runs", double (! strncmp (r.derivatives, "carried", 7)), 0);
  law = r.laws.law;
  for limit = [40 8]
    law.limits = [-limit, limit];
    mc = gsmbp_build (r.model.name, "directory", r.model.directory, "controller", law, ...
                      "parameters", r.model.par);
    run = @(m, varargin) gsmbp_simulate (m, [0 0 0], 0:0.02:0.2, "input", 0.1, "rtol", 1e-12, ...
                                         varargin{:});
    a = run (mc, "sensitivity", {"ml", "motor_K"});
    for name = {"ml", "motor_K"}
      h = 1e-5 * mc.par.(name{1});
      at = @(s) run (gsmbp_set (mc, name{1}, mc.par.(name{1}) + s * h)).x;
      b = (8 * (at (1) - at (-1)) - (at (2) - at (-2))) / (12 * h);
      told = sprintf ("derivatives by %s, voltage up to %g", name{1}, max (abs (a.v(:,1))));
      gsmbp_check (told, (a.dx.(name{1}) - b) ./ max (abs (b)), 1e-6);
    end
  end
end

function the_page (r, text)
  there = @(said) any (strfind (text, said));
  missing = {};
  escaped = @(t) strrep (strrep (strrep (t, "&", "&amp;"), "<", "&lt;"), ">", "&gt;");
  for said = [{r.decisions.chosen}, r.decisions(1).why, {r.more.said}, "All demands are met"]
    if (! there (escaped (said{1})))
      missing{end+1} = said{1};
    end
  end
  gsmbp_check (["the page says " strjoin(missing, "; ")], numel (missing), 0);
  gsmbp_check ("pictures stand in it", double (! (there ("data:image/png") && there ("<svg"))), 0);
  gsmbp_check ("it fetches nothing", double (there ("http://") && ! there ("www.w3.org")), 0);
end

## no drive; no accuracy
function what_is_not_met (m, s)
  s.tolerances = cell (0, 2);
  s.springs = cell (0, 2);
  s.supply = 1;
  r = gsmbp_design (m, s);
  gsmbp_check ("no drive", double (r.met || ! strncmp (r.unmet.said, "drive of q: none", 16)), 0);
  gsmbp_check ("says so", double (! any (strfind (fileread (s.file), "Not met:"))), 0);
  [s.supply, s.accuracy, s.tries, s.goal, s.file] = deal (Inf, 1e-6, 1, "mass", "");
  r = gsmbp_design (m, s);
  one = r.unmet(strcmp ({r.unmet.name}, "tracking error"));
  gsmbp_check ("no accuracy below the encoder's steps", ...
               double (r.met || one.found <= 1e-6 || one.demanded != 1e-6), 0);
end

function refusals (m, s)
  says = @(text, varargin) gsmbp_check (text, double (! any (strfind (gsmbp_complaint ( ...
    @() gsmbp_design (m, varargin{:})), text))), 0);
  says ("the specification lacks accuracy", "motion", s.motion, "period", 1e-3);
  says ("motion: expected a plan", setfield (s, "motion", 3));
  says ("accuracy: expected 1 or 1 numbers (for q), found 2", setfield (s, "accuracy", [1 2]));
  says ("unknown parameter \"mm\"", setfield (s, "tolerances", {"mm", 0.1}));
  says ("tolerances: expected rows as {\"m3\", 0.1}", setfield (s, "tolerances", {"ml", 2}));
  says ("file: expected a name that ends in .html", setfield (s, "file", "a.pdf"));
  arm = gsmbp_fixture ("control_arm");
  gsmbp_check ("an arm without motors", double (! any (strfind (gsmbp_complaint ( ...
    @() gsmbp_design (arm, s)), "expected one dc_motor that drives it, found 0"))), 0);
end
