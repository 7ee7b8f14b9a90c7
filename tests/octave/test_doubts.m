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
  proposed (m, d, noise);
  times (m, d);
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
