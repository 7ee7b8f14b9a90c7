## Every variant of every entry of the library: it starts, it has an equilibrium, it is run into its
## limits and comes back.

function test_library ()
  m = gsmbp_fixture ("library_ports");
  units (m, "on ports");
  start (m, "on ports", 1e-6);
  eq = trim (m, "on ports");
  limits (m, eq);
  s = gsmbp_fixture ("library_signals");
  units (s, "signals");
  units (gsmbp_fixture ("mech_digital"), "sampled");
  start (s, "signals", []);
  trim (s, "signals");
  bounds (s);
end

## no unit has a word in it that entries use for what they do not know (x, y, port)
function units (m, what)
  known = {"kg", "m", "s", "A", "K", "N", "Pa", "J", "W", "V", "ohm", "H", "F", "C", "T", "Wb", ...
           "Hz", "rad"};
  all = cellfun (@(kind) m.units.(kind)(:), fieldnames (m.units), "UniformOutput", false);
  all = unique (vertcat (all{:}));
  words = regexp (all, "[A-Za-z_]+", "match");
  words = unique ([words{:}]);
  gsmbp_check (["units are those of the SI, " what], ismember (words, known));
  gsmbp_check (["energy per length and angle is force and torque, " what], ...
               cellfun ("isempty", regexp (all, "J/(m|rad)$|J[^/]*/(m|rad)\\^")));
end

## rates are finite, nothing jumps in the first 1e-7 s, the first steps balance their energy
function start (m, what, energy)
  v = zeros (m.sizes.nv, 1);
  rates = m.rhs (0, m.initial, v);
  gsmbp_check (["finite rates at the start, " what], isfinite (rates));
  options = {"method", "cvode", "rtol", 1e-8};
  if (! isempty (energy))
    options = [options, {"audit", 1}];
  end
  r = gsmbp_simulate (m, m.initial, [0, 1e-7, 1e-4, 1e-3, 1e-2], options{:});
  gsmbp_check (["finite states in the first 10 ms, " what], isfinite (r.x(:)));
  moved = r.x(2,:)' - m.initial - 1e-7 * rates;
  gsmbp_check (["first 0.1 us: no jump, of the usual sizes, " what], moved ./ m.nominal, 1e-4);
  if (! isempty (energy))
    gsmbp_check (["energy of the first 10 ms, " what], r.audit.error, energy);
  end
end

## the equilibrium with all inputs zero
function r = trim (m, what)
  r = gsmbp_trim (m, m.initial, zeros (m.sizes.nv, 1));
  gsmbp_check (["equilibrium: what is left, of the usual sizes, " what], r.residual, 1e-9);
  rates = m.rhs (0, r.x, r.v) ./ m.nominal;
  gsmbp_check (["equilibrium: rates, of the usual sizes, " what], rates, 1e-9);
end

## full inputs one way, the other way, none: slides come to their stops, pressures to supply and
## exhaust, all come back
function limits (m, eq)
  sizes = struct ("A", 20, "J_rad", 0.5, "N_m", 0.5, "V", 60, "V_s", 0, "m", 1e-3, "m_2", 1e-5, ...
                  "rad", 0.01, "rad_s", 0);
  full = cellfun (@(u) sizes.(regexprep (u, "[/*^]", "_")), m.units.inputs);
  coefs = reshape ([full, -full, 0 * full], [], 1);
  v = mkpp ([0, 0.3, 0.6, 3], coefs, numel (full));
  r = gsmbp_simulate (m, eq.x, 0:0.02:3, "input", v, "method", "cvode", "rtol", 1e-6);
  gsmbp_check ("limits: all states stay finite", isfinite (r.x(:)));
  name = @(k) strtok (m.states{k}, ".");
  reached = [];
  outside = left = [];
  for k = find (strcmp (m.units.states, "Pa"))'
    gas = isfield (m.par, [name(k) "_pa"]);
    if (! gas && ! isfield (m.par, [name(k) "_a1"]))
      continue;   # a hydraulic motor's wheel drives oil beyond both pressures
    end
    low = parameter (m, name (k), {"_pa", "_pt"});
    high = m.par.([name(k) "_ps"]);
    if (! isempty (regexp (m.states{k}, "\\.pl$")))
      low = -high;
    end
    outside(end+1) = max ([low - min(r.x(:,k)), max(r.x(:,k)) - high]) / high;
    reached(end+1) = max (r.x(:,k)) > 0.95 * high;
    left(end+1) = r.x(end,k) < 0.995 * high && r.x(end,k) > low;
  end
  gsmbp_check ("limits: pressures stay between supply and exhaust, of the supply", outside, 0.01);
  gsmbp_check ("limits: pressures come up to the supply's", reached);
  gsmbp_check ("limits: pressures leave their limits", left);
  slides = find (strcmp (m.units.coordinates, "m"))';
  gsmbp_check ("limits: slides stay between their stops [m]",
               max (0, [max(r.x(:,slides)) - 0.075, 0.005 - min(r.x(:,slides))]), 0.005);
  x = r.x(:,slides)(:);
  gsmbp_check ("limits: some slide comes to each stop", [max(x) > 0.075, min(x) < 0.005]);
  recovered (m, eq, r);
end

function p = parameter (m, device, words)
  for w = words
    if (isfield (m.par, [device w{1}]))
      p = m.par.([device w{1}]);
      return;
    end
  end
end

## wheels are back at their equilibrium, or on their way
function recovered (m, eq, r)
  d = m.sizes;
  swing = max (abs (r.x(:,1:d.nq) - eq.x(1:d.nq)'))';
  quick = strcmp (m.units.coordinates, "rad") & swing > 1e-6;
  back = abs (r.x(end,1:d.nq)' - eq.x(1:d.nq)) ./ max (swing, 1e-6);
  gsmbp_check ("limits: wheels that are back at their equilibrium", sum (back(quick) < 0.01) >= 20);
  gsmbp_check ("limits: nothing hangs at a limit: far from where it was", back(quick) < 0.7);
end

## outputs of what has a bound: it is reached both ways, never passed
function bounds (m)
  v = zeros (m.sizes.nv, 1);
  driven = find (! cellfun (@isempty, regexp (m.inputs, "\\.(reference|u|measure)$")));
  v(driven) = 1e4;
  v(driven(strcmp (m.units.inputs(driven), "Pa"))) = 1e9;
  coefs = [v, -v](:);
  r = gsmbp_simulate (m, m.initial, 0:0.05:2, "input", mkpp ([0, 1, 2], coefs, numel (v)), ...
                      "method", "cvode", "rtol", 1e-6);
  gsmbp_check ("bounds: states stay finite", isfinite (r.x(:)));
  passed = reached = [];
  tried = {};
  for name = fieldnames (m.par)'
    part = regexp (name{1}, "^d(\\d+)_(.*)_(Vm|Im|umax|range)$", "tokens");
    if (! isempty (part) && ! any (strcmp (part{1}{2}, {"linear", "lag"})))
      y = r.y(:,str2double (part{1}{1})) / m.par.(name{1});
      passed(end+1) = max (abs (y)) - 1;
      reached(end+1) = max (y) > 0.9 && min (y) < -0.9;
      tried{end+1} = name{1};
    end
  end
  full = ! cellfun (@isempty, regexp (m.states, "_full\\.x$"));
  slew = find (full & strcmp (m.units.states, "A"));
  rates = [m.rhs(0, m.initial, v), m.rhs(0, m.initial, -v)](slew,:);
  gsmbp_check ("rate limit of the current, of it", max (abs (rates)) / 8000 - 1, 1e-6);
  gsmbp_check (sprintf ("bounds of %d devices are not passed, of them", numel (passed)), ...
               max (passed, 0), 1e-12);
  gsmbp_check ("bounds are reached both ways", reached);
  tried = sort ([tried, strrep(m.states(slew)(:)', "_full.x", "_full_slew")]);
  known = registered_bounds ();
  left = setxor (tried, known);
  gsmbp_check (sprintf ("the %d bounds of the registry are those that were tried: %s", ...
                        numel (known), strjoin (left, ", ")),
               numel (known) > 20 && isempty (left));
end

## the bounds of the devices of library_signals, read out of the registered entries: parameters
## that saturate a rate, an output or an update, in max(-P, min(P, ...)) or (1 + (.../P)^8)^(1/8)
function names = registered_bounds ()
  root = fileparts (fileparts (fileparts (mfilename ("fullpath"))));
  log = [tempname() ".log"];
  text = sprintf ("load(\"%s/gsmbp/gsmbp.mac\")$ load(\"%s/tests/%s\")$ %s", root, root, ...
                  "scenes/library_signals.mac", strjoin ({ ...
    "within(x) := block([inflag : true], if mapatom(x) then []", ...
    "  elseif op(x) = \"^\" and second(x) = -8 then listofvars(first(x))", ...
    "  elseif member(op(x), ['max, 'min]) then", ...
    "    append(sublist(args(x), symbolp), xreduce(append, map(within, args(x)), []))", ...
    "  else xreduce(append, map(within, args(x)), []))$", ...
    "own(e, v) := block([f, p : gs__field(gs__entry(e), 'parameters)],", ...
    "  f : append(assoc(v, gs__field(gs__entry(e), 'variants)), gs__entry(e)),", ...
    "  f : map(lambda([n], gs__list_field(f, n)), '[rates, outputs, update]),", ...
    "  p : map(first, sublist(p, lambda([r], third(r) # \"s\"))),", ...
    "  intersection(setify(within(f)), setify(p)))$", ...
    "for k thru length(every_one) do", ...
    "  for p in own(every_one[k][1], every_one[k][2]) do", ...
    "    printf(true, \"bound: ~a_~a~%\", device(k), p)$"}, "\n"));
  quoted = @(s) ["'" strrep(s, "'", "'\\''") "'"];
  status = system (sprintf ("%s %s %s", quoted (fullfile (root, "share", "make", "maxima")), ...
                            quoted (log), quoted (text)));
  gsmbp_check ("the registry is read", status == 0);
  names = sort (cellfun (@(t) t{1}, regexp (fileread (log), "bound: (\\w+)", "tokens"), ...
                         "UniformOutput", false));
  delete (log);
end
