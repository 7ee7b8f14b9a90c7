## gsmbp_identify doubts its data: each fault of a measurement is named with its column and size,
## sound data are not doubted. The cutoff that gsmbp_measured proposes; times in another unit.

function test_doubts ()
  m = gsmbp_fixture ("ident_crane");
  d = crane_motion ((0:0.005:5)');
  randn ("twister", 1);
  d.tau += [1, 0.2] .* randn (size (d.tau));
  sound_ (m, d);
  one = @(said, varargin) doubted (m, setfield (d, varargin{:}), said);
  one ({"phi = -.* rad is outside the limits of its joint, -1.5 to 1.5; 9.. of 981 rows are"}, ...
       "q", d.q .* [1, 180/pi]);
  one ({"s = .* m is outside the limits of its joint", ...
        "the residual has an rms of .* of the signal"}, "q", d.q .* [1000, 1]);
  one ({"effort.s: the residual .* of the signal", "effort.phi: the residual .* of the signal", ...
        "better with effort.s and effort.phi swapped: the residual is then 0.03.. .* now 0.8"}, ...
       "tau", d.tau(:,[2 1]));
  one ({"trolley_mR = -13.* is negative", "better with effort.s of the other sign"}, "tau", ...
       d.tau .* [-1, 1]);
  one ({"better with s of the other sign, or with phi of the other sign"}, "q", ...
       d.q .* [1, -1]);
  one ({"better with s and phi swapped"}, "q", d.q(:,[2 1]));
  noise = [5e-4, 0.05*pi/180] .* randn (size (d.q));
  one ({"effort.s: the residual correlates by -0.[5-9].* noise of the acceleration of s"}, "q", ...
        d.q + noise);
  no_body (m, d);
  swapped_all (m, d);
  late (m, d);
  rescaled (m, d);
  rates (m, d);
  not_finite (m, d);
  proposed (m, d, noise);
  times (m, d);
  exact (m);
end

function sound_ (m, d)
  e = identified (m, d, 20, "weights", "residual");
  gsmbp_check ("sound data are not doubted", isempty (e.doubts));
  e = identified (m, d, 20, "sigma", [1, 0.2]);
  gsmbp_check ("... nor with sigma", isempty (e.doubts));
  e = identified (m, d, 20, "method", "total");
  gsmbp_check ("... nor by total least squares", isempty (e.doubts));
  e = identified (m, d, 20, "sigma", [0.2, 0.2]);
  gsmbp_check ("sigma too small", numel (e.doubts) == 1 && ! isempty (regexp (e.doubts{1}, ...
    "effort.s: the residual has an rms of 1.*, which is [45].* times its sigma")));
end

function e = identified (m, d, cutoff, varargin)
  warning ("off", "gsmbp:identify", "local");
  f = gsmbp_measured (m, struct ("t", d.t, "q", d.q, "tau", d.tau), "cutoff", cutoff);
  e = gsmbp_identify (m, f, varargin{:});
end

function doubted (m, d, said)
  e = identified (m, d, 20, "weights", "residual");
  for text = said
    gsmbp_check (["doubted: " text{1}], any (! cellfun (@isempty, regexp (e.doubts, text{1}))));
  end
end

## a pin's inertia below that of a point mass with the same moment: no number is negative
function no_body (m, d)
  d.tau(:,2) -= 0.5 * d.ud(:,2);
  e = identified (m, d, 20, "weights", "residual");
  gsmbp_check ("an inertia of 0.08 that is none", e.p(4) > 0.05 && numel (e.doubts) == 1 ...
               && any (strfind (e.doubts{1}, "no body has these masses and inertias")));
end

function swapped_all (m, d)
  d = setfield (d, "q", d.q(:,[2 1]));
  doubted (m, setfield (d, "tau", d.tau(:,[2 1])), ...
           {"better with all columns of s and phi swapped: the residual is then 0.03"});
end

## efforts late and early by samples of 5 ms; friction that the model lacks is no delay
function late (m, d)
  x = d;
  x.tau(4:end,1) = d.tau(1:end-3,1);
  x.tau(1:end-4,2) = d.tau(5:end,2);
  e = identified (m, x, 20);
  said = regexp (e.doubts, ['^effort.(\w+) is (late|early) by ([\d.]+) s .* samples\) against ' ...
                            'the motion: shifted, its residual is 0.[4-8]'], "tokens", "once");
  gsmbp_check ("doubted: an effort late, the other one early", numel (e.doubts) == 2 ...
               && isequal (said{1}(1:2)(:)', {"s", "late"}) ...
               && isequal (said{2}(1:2)(:)', {"phi", "early"}));
  gsmbp_check ("... by their delays", ...
               [str2double(said{1}{3}) - 0.015, str2double(said{2}{3}) - 0.020], 0.001);
  d = crane_motion ((0:0.005:5)');
  few = {};
  for seed = 1:8
    randn ("twister", seed);
    x.tau = d.tau + [1, 0.2] .* randn (size (d.tau)) ...
            + [seed, 0.05*seed] .* [sign(d.u(:,1)), d.u(:,2).*abs(d.u(:,2))];
    few = [few, identified(m, x, 20).doubts];
  end
  gsmbp_check ("... friction that the model lacks is no delay", ! any (cellfun (@(x) ...
    ! isempty (regexp (x, "late|early|each other")), few)));
end

## one effort in another unit than the other, which shared parameters tell
function rescaled (m, d)
  for k = [0.001, 0.5, 2, 1000]
    x = d;
    x.tau(:,1) *= k;
    e = identified (m, x, 20);
    said = regexp ([e.doubts{:}], "fit each other better with effort.(\\w+) times ([\\d.e+-]+)", ...
                   "tokens", "once");
    factor = str2double (said{2}) ^ (1 - 2 * strcmp (said{1}, "phi"));
    gsmbp_check (sprintf ("doubted: an effort times %g", k), abs (factor * k - 1) < 0.05);
  end
end

## speeds and accelerations that are not the rates
function rates (m, d)
  f = struct ("t", d.t, "q", d.q, "u", d.u, "ud", d.ud, "tau", d.tau);
  warning ("off", "gsmbp:identify", "local");
  gsmbp_check ("measured speeds are not doubted", isempty (gsmbp_identify (m, f).doubts));
  noise = [5e-4, 0.05*pi/180] .* randn (size (d.q));
  gsmbp_check ("... nor where the positions have noise", ...
               isempty (gsmbp_identify (m, setfield (f, "q", d.q + noise)).doubts));
  one = @(said, varargin) gsmbp_check (["doubted: " said], any (! cellfun (@isempty, regexp ( ...
    gsmbp_identify (m, setfield (f, varargin{:})).doubts, said))));
  one ("u.phi is not the rate of phi: its integral misses it .* of the motion; times 0.0175 it", ...
       "u", d.u .* [1, 180/pi]);
  one ("u.s is not the rate of s: its integral misses it by an rms of 0.605", "u", d.u(:,[2 1]));
  one ("ud.s is not the rate of u.s: .* which is 2 of the motion; times -1 it fits", ...
       "ud", d.ud .* [-1, 1]);
end

function not_finite (m, d)
  for field = {"q", "tau"}
    x = struct ("t", d.t, "q", d.q, "u", d.u, "ud", d.ud, "tau", d.tau);
    x.(field{1})(17,2) = NaN;
    text = sprintf ("data.%s: expected finite numbers, found NaN in row 17, column 2 \\(phi\\)", ...
                    field{1});
    gsmbp_check (text, ! isempty (regexp (gsmbp_complaint (@() gsmbp_identify (m, x)), text)) ...
                 && ! isempty (regexp (gsmbp_complaint (@() gsmbp_measured (m, x)), text)));
  end
end

## the error of the accelerations at the cutoff that is proposed and at others
function proposed (m, d, noise)
  s = struct ("t", d.t, "q", d.q + noise, "tau", d.tau);
  f = gsmbp_measured (m, s, "cutoff", "auto");
  cutoffs = logspace (0, 1.5, 40);
  for k = 1:numel (cutoffs)
    off(k) = error_of (gsmbp_measured (m, s, "cutoff", cutoffs(k)), d);
  end
  [least, k] = min (off);
  gsmbp_check (sprintf (["the cutoff proposed, %.3g Hz, is near the best, %.3g Hz: error " ...
                         "of accelerations %.3g and %.3g"], f.cutoff, cutoffs(k), ...
                        error_of (f, d), least), error_of (f, d) < 2 * least);
end

## of the rows that are kept, over the rms of the accelerations
function off = error_of (f, d)
  ud = interp1 (d.t, d.ud, f.t);
  off = norm ((f.ud - ud) ./ sqrt (mean (d.ud .^ 2)), "fro") / sqrt (rows (ud));
end

function times (m, d)
  says = @(t, text, varargin) gsmbp_check (text, ! isempty (regexp (gsmbp_complaint ( ...
    @() gsmbp_measured (m, struct ("t", t, "q", d.q, "tau", d.tau), varargin{:})), text)));
  says (d.t / 1000, ["no row is left of 1001: the times last 0.005 s, steps of 5e-06 s; .* 0.05" ...
                     " s at both ends; do the times have the unit that their head says"], ...
        "cutoff", 20);
  says (1000 * d.t, "found 20; are the times in milliseconds", "cutoff", 20);
  says (d.t, "option cutoff: .auto., .spline. or a frequency", "cutoff", -1);
end

## exact data of five scenes, as they are, by differences and through the filter that is proposed:
## no doubt, where an effort is zero neither; of the other sign they are doubted all the same
function exact (crane)
  robot = gsmbp_fixture ("base_robot");
  scara = gsmbp_fixture ("ident_scara");
  for m = {crane, robot, gsmbp_fixture("case_d5a"), gsmbp_fixture("ident_arm"), scara, ...
           gsmbp_set(scara, "jq", 0)}
    d = exact_motion (m{1});
    few = struct ("t", d.t, "q", d.q, "tau", d.tau);
    warning ("off", "gsmbp:identify", "local");
    list = gsmbp_identify (m{1}, d, "weights", "residual").doubts;
    for x = {d, gsmbp_measured(m{1}, few), gsmbp_measured(m{1}, few, "cutoff", "auto")}
      list = [list, gsmbp_identify(m{1}, x{1}).doubts];
    end
    gsmbp_check ([m{1}.name ": exact data are not doubted" sprintf("; %s", list{:})], ...
                 isempty (list));
    x = gsmbp_measured (m{1}, few, "cutoff", 20);
    gsmbp_check ("... what a filter takes from the motion is no noise", ...
                 isempty (strfind ([gsmbp_identify(m{1}, x).doubts{:}, ""], "noise")));
    e = gsmbp_identify (m{1}, setfield (d, "tau", -d.tau));
    gsmbp_check ([m{1}.name ": ... but with efforts of the other sign"], ...
                 any (! cellfun (@isempty, regexp (e.doubts, "is negative, which no body is$"))));
  end
end

## three harmonics in 4 s, 0.02 s apart
function d = exact_motion (m)
  n = m.sizes.nu;
  rand ("twister", 5);
  t = (0:0.02:4)';
  d = struct ("t", t, "q", zeros (numel (t), n), "u", zeros (numel (t), n), "ud", ...
              zeros (numel (t), n), "tau", zeros (numel (t), n));
  for j = 1:n
    for w = 2 * pi / 5 * (1:3)
      a = (2 * rand () - 1) * 2 * pi / 5 / w;
      p = w * t + 2 * pi * rand ();
      d.q(:,j) += a * sin (p);
      d.u(:,j) += a * w * cos (p);
      d.ud(:,j) -= a * w ^ 2 * sin (p);
    end
  end
  for i = 1:numel (t)
    d.tau(i,:) = m.inv (0, d.q(i,:)', d.u(i,:)', d.ud(i,:)', zeros (numel (m.inputs), 1));
  end
end
