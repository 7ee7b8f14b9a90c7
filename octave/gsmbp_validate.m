## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {@var{v} =} gsmbp_validate (@var{m}, @var{e}, @var{data})
## @deftypefnx {} {@var{v} =} gsmbp_validate (@var{m}, @var{e}, @var{data}, "file", @var{file})
## Hold estimates against a motion that they were not made from.
##
## @var{e} is a result of @code{gsmbp_identify} or @code{gsmbp_consistent} for the model @var{m},
## @var{data} another one of @code{gsmbp_measured}.  @var{v} has the fields @code{t},
## @code{measured} and @code{predicted} (times x efforts), @code{nominal}, what the model says with
## the parameters it has, @code{rms} of what the prediction misses, @code{relative}, the same over
## the rms of the measured effort, and @code{rms_nominal}.  Option "file": draws measured,
## predicted and the difference (@code{gsmbp_plot}), a panel for each effort.
##
## @c session octave
## @example
## >> m = gsmbp_build ("pinned");
## >> heavy = gsmbp_set (m, "mb", 2.5, "d", 0.3);
## >> p = gsmbp_plan ("quintic", [0 2 -1], [0 1 2.5]);
## >> r = gsmbp_inverse (heavy, p, 0:0.02:2.5);
## >> data = struct ("t", r.t, "q", r.q, "u", r.u, "ud", r.ud, "tau", r.tau);
## >> e = gsmbp_identify (m, data, "sigma", 0.1);
## >> v = gsmbp_validate (m, e, data);
## >> v.rms < 1e-12
## ans = 1
## >> v.rms_nominal
## ans = 1.2005
## @end example
##
## Errors: as of @code{gsmbp_identify}; estimates of another model.
## Source: own.
## @seealso{gsmbp_identify, gsmbp_consistent, gsmbp_measured}
## @end deftypefn

function v = gsmbp_validate (m, e, data, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_validate";
  gs.given.check_model (who, m);
  if (ischar (data))
    gs.identify.sound_data (who, m, data, {});   # before the options say what they miss
  endif
  gs.given.check_open_chain (who, m);
  gs.given.check_estimates (who, e);
  o = gs.given.call_options (who, {"file", "", "text"}, varargin);
  data = gs.identify.sound_data (who, m, data, {});
  w = gs.identify.regression_rows (who, m, data, setfield (e.options, "motors", ...
                                                           e.options.motors([])));
  p = w.p;
  for k = 1:numel (e.names)
    at = strcmp (w.names, e.names{k});
    if (any (at))
      p(at) = e.p(k);
    elseif (! strcmp (e.kind{k}, "motor"))
      error ("%s: %s has no parameter %s: expected estimates of this model", who, m.name, ...
             e.names{k});
    endif
  endfor
  n = m.sizes.nu;
  shaped = @(x) reshape (x, n, [])';
  [v.t, v.measured] = deal (data.t, data.tau);
  v.predicted = shaped (w.Y * p + w.r);
  base = strcmp (w.kind, "base")';
  v.nominal = shaped (w.Y(:,base) * w.p(base) + w.r);
  v.rms = sqrt (mean ((v.measured - v.predicted) .^ 2, 1));
  v.relative = v.rms ./ sqrt (mean (v.measured .^ 2, 1));
  v.rms_nominal = sqrt (mean ((v.measured - v.nominal) .^ 2, 1));
  if (! isempty (o.file))
    draw (o.file, m, v);
  endif
endfunction

function draw (file, m, v)
  panels = cell (1, m.sizes.nu);
  for k = 1:m.sizes.nu
    unit = {"N m", "N"}{1 + strncmp(m.units.coordinates{k}, "m", 1)};
    name = m.coordinates{k};
    y = [v.measured(:,k), v.predicted(:,k), v.measured(:,k) - v.predicted(:,k)];
    panels{k} = struct ("y", y, "names", {{["measured, " name], "predicted", "difference"}}, ...
                        "label", sprintf ("effort on %s [%s]", name, unit));
  endfor
  gsmbp_plot (file, v.t, panels{:});
endfunction

%!error <argument e: expected a result of gsmbp_identify>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! gsmbp_validate (gsmbp_hand ("motor_pendulum"), 3, 4)
