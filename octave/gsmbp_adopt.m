## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {[@var{m}, @var{table}] =} gsmbp_adopt (@var{m}, @var{e}, @var{names})
## @deftypefnx {} {[@var{m}, @var{table}] =} gsmbp_adopt (@dots{}, @var{option}, @var{value}, @
## @dots{})
## Write estimates back into the parameters of a scene, with their uncertainty.
##
## Base parameters are made of masses, centres, moments of inertia and friction of the scene;
## @var{names} are the parameters of the model @var{m} that may change for it to have the base
## parameters of @var{e} (of @code{gsmbp_identify} or @code{gsmbp_consistent}).  By Gauss-Newton the
## weighted misfit to these becomes as small as it can, with the least relative change of the
## parameters: combinations that the base parameters do not know, or know only to more than "spread"
## of their value, keep it.
##
## Options: "spread": a relative standard deviation (default 1); "map": estimates that are a
## parameter themselves, by name and parameter in turn (@code{@{"q1_K", "motor_K"@}}, where the
## scene has such a parameter); "file": writes @var{table} as comma-separated values.
##
## @var{table}: a struct array with @code{name}, @code{value}, @code{sigma} (standard deviation;
## what the estimates do not determine counts with "spread" times the value), @code{before},
## @code{determined} (that does not matter).  The second field of @code{[m, table, misfit]} is the
## largest miss of a base parameter in its standard deviations: far above 1 says that @var{names}
## cannot make these estimates.
##
## @c session octave
## @example
## >> m = gsmbp_build ("pinned");
## >> heavy = gsmbp_set (m, "mb", 2.5, "d", 0.3);
## >> p = gsmbp_plan ("quintic", [0 2 -1], [0 1 2.5]);
## >> r = gsmbp_inverse (heavy, p, 0:0.02:2.5);
## >> data = struct ("t", r.t, "q", r.q, "u", r.u, "ud", r.ud, "tau", r.tau);
## >> e = gsmbp_identify (m, data, "sigma", 0.1);
## >> [m, table] = gsmbp_adopt (m, e, @{"mb", "d"@});
## >> [table.value; table.before]
## ans =
##
##    2.5000   0.3000
##    2.0000   0.1000
## @end example
##
## Errors: unknown parameters; lengths and gravity, which are in the factors of base parameters;
## values that the scene refuses (a negative mass: take @code{gsmbp_consistent}); no convergence.
## Source: own; least squares of least norm.
## @seealso{gsmbp_identify, gsmbp_consistent, gsmbp_set}
## @end deftypefn

function [m, table, misfit] = gsmbp_adopt (m, e, names, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_adopt";
  gs.given.check_model (who, m);
  gs.given.check_estimates (who, e);
  gs.given.check_kind (who, "argument names", names, "names");
  names = cellstr (names)(:)';
  o = gs.given.call_options (who, {"map", {}, "names"; "spread", 1, "positive"
                             "file", "", "text"}, varargin);
  for name = [names, o.map(2:2:end)]
    if (! isfield (m.par, name{1}))
      error ("%s: %s: unknown parameter %s", who, m.name, ...
             gs.text.nearest_word (name{1}, fieldnames (m.par)'));
    endif
  endfor
  only_in_p (who, m, names);
  base = strcmp (e.kind, "base");
  weight = inv (chol (e.covariance(base,base))');
  [theta, J, misfit] = fitted (who, m, e, base, weight, names, o.spread);
  table = told (m, e, names, theta, J, o);
  values = [{table.name}; {table.value}];
  m = gsmbp_set (m, values{:});
  if (! isempty (o.file))
    text = cellfun (@(r) sprintf ("%s,%.17g,%.17g,%.17g,%d\n", r.name, r.value, r.sigma, ...
                                  r.before, r.determined), num2cell (table), ...
                    "UniformOutput", false);
    gs.files.write_text (who, o.file, ["name,value,sigma,before,determined\n", [text{:}]]);
  endif
endfunction

## lengths and gravity are in the factors of the base parameters, which hold for their values alone
function only_in_p (who, m, names)
  d = m.sizes;
  at = {0, sin((1:d.nq)'), cos((1:d.nu)'), sin(2 * (1:d.nu)'), zeros(d.nv, 1)};
  Y = m.reg (at{:});
  for name = names
    other = m;
    other.par.(name{1}) += 1e-3 * max (abs (other.par.(name{1})), 1e-3);
    other = gs.model.model_handles (other);
    if (norm (other.reg (at{:}) - Y, Inf) > 1e-9 * norm (Y, Inf))
      error (["%s: %s: parameter %s is in the factors of the base parameters (a length, " ...
              "gravity): expected masses, centres, inertias or friction"], who, m.name, name{1});
    endif
  endfor
endfunction

## Gauss-Newton with steps of least norm in parameters over their size
function [theta, J, misfit] = fitted (who, m, e, base, weight, names, spread)
  theta = cellfun (@(n) m.par.(n), names)';
  size_of = max (abs (theta), 1e-3 * max ([abs(theta); 1e-3]));
  own = ismember (gs.given.names_and_units (m.json.base_parameters), e.names(base));
  standard = gs.identify.standard_parameters (m);
  all = cell2mat (struct2cell (m.par));
  [~, places] = ismember (names, fieldnames (m.par));
  of = @(x) base_of (standard, all, places, x)(own);
  y = theta ./ size_of;
  for step = 1:50
    miss = weight * (e.p(base) - of (y .* size_of));
    J = weight * slope (of, y, size_of);
    move = least (J, miss, spread);
    y += move;
    if (norm (move) <= 1e-10 * (1 + norm (y)) || norm (J * move) <= 1e-6)
      theta = y .* size_of;
      misfit = max (abs (e.p(base) - of (theta)) ./ sqrt (diag (e.covariance)(base)));
      J ./= size_of';
      return;
    endif
  endfor
  error ("%s: %s: no convergence in 50 steps; the last one changes the parameters by %.1e", who, ...
         m.name, norm (move));
endfunction

function move = least (J, miss, spread)
  [U, s, V] = known (J, spread);
  move = V * ((U' * miss) ./ s);
endfunction

## the directions that are known to SPREAD or better
function [U, s, V] = known (J, spread)
  [U, S, V] = svd (J, "econ");
  s = diag (S);
  k = s > max (1e-7 * max (s), 1 / spread);
  [U, s, V] = deal (U(:,k), s(k), V(:,k));
endfunction

## central differences; base parameters are polynomials of low degree
function J = slope (of, y, size_of)
  J = zeros (numel (of (y .* size_of)), numel (y));
  for k = 1:numel (y)
    h = 1e-4 * (1:numel (y) == k)';
    J(:,k) = (of ((y + h) .* size_of) - of ((y - h) .* size_of)) / 2e-4;
  endfor
endfunction

function p = base_of (s, all, places, theta)
  all(places) = theta;
  [K, x] = s.at (all);
  p = K * x;
endfunction

function table = told (m, e, names, theta, J, o)
  size_of = max (abs (theta), 1e-3 * max ([abs(theta); 1e-3]))';
  [~, s, V] = known (J .* size_of, o.spread);
  sigma = sqrt (sumsq (size_of' .* V ./ s', 2));
  part = max (1 - sumsq (V, 2), 0);   # of a parameter in what is not known
  sigma = sqrt (sigma .^ 2 + (o.spread * size_of') .^ 2 .* part);
  loose = part > 0.01;
  table = struct ("name", {}, "value", {}, "sigma", {}, "before", {}, "determined", {});
  for k = 1:numel (names)
    table(end+1) = struct ("name", names{k}, "value", theta(k), "sigma", sigma(k), "before", ...
                           m.par.(names{k}), "determined", ! loose(k));
  endfor
  for k = 1:2:numel (o.map)
    at = find (strcmp (e.names, o.map{k}));
    if (isempty (at))
      error ("gsmbp_adopt: option map: unknown estimate %s", ...
             gs.text.nearest_word (o.map{k}, e.names(:)'));
    endif
    table(end+1) = struct ("name", o.map{k+1}, "value", e.p(at), "sigma", e.sigma(at), "before", ...
                           m.par.(o.map{k+1}), "determined", true);
  endfor
endfunction

%!error <argument e: expected a result of gsmbp_identify>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! gsmbp_adopt (gsmbp_hand ("motor_pendulum"), 3, "g")
