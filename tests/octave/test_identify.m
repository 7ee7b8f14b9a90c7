## Identification: the case D5a (estimates and covariance in numbers of 25 digits); against least
## squares by hand; further columns and motor constants; estimates that bodies can have; parameters
## written back. Repeats with noise and exciting motions: test_excite.m.

function test_identify ()
  rand ("twister", 3);
  m = gsmbp_fixture ("case_d5a");
  [d, ref] = case_d5a ();
  reference (m, d, ref);
  by_hand (m, d);
  consistent_puma (m, d);
  m = gsmbp_fixture ("ident_arm");
  d = ident_motion (m, 60, 0);
  more_columns (m, d);
  motor_constants (m, d);
  not_told_apart (m, d);
  consistent (m, d);
  written_back (m, d);
end

function [d, ref] = case_d5a ()
  here = fileparts (fileparts (mfilename ("fullpath")));
  folder = fullfile (here, "data", "D5a_ident_puma3");
  [~, ref] = gsmbp_case ("D5a_ident_puma3");
  table = dlmread (fullfile (folder, "data.csv"), ",", 1, 0);
  d = struct ("t", table(:,1), "q", table(:,2:4), "u", table(:,5:7), "ud", table(:,8:10), "tau", ...
              table(:,11:13));
end

## the reference has other base parameters: A takes them to those of GSMBP
function reference (m, d, ref)
  e = gsmbp_identify (m, d, "sigma", [0.5 0.8 0.2]);
  A = others (m, ref);
  p = A * ne_numbers (ref.estimate);
  C = A * ne_numbers (ref.covariance) * A';
  gsmbp_check ("D5a: 15 base parameters", numel (e.p) == 15);
  gsmbp_check ("D5a: estimates, in their standard deviations", (e.p - p) ./ sqrt (diag (C)), 1e-10);
  gsmbp_check ("D5a: estimates", norm (e.p - p) / norm (p), 1e-10);
  s = sqrt (diag (C));
  gsmbp_check ("D5a: covariance", (e.covariance - C) ./ (s * s'), 1e-10);
  gsmbp_check ("D5a: values of the model", e.nominal - A * ne_numbers (ref.true_values), 1e-13);
  part = e.chi2 / e.dof;
  gsmbp_check (sprintf ("D5a: chi2/dof %.6f", part), part - 0.969778056492168, 1e-10);
end

## the base parameters of GSMBP from those of the reference: both are factors of the standard ones,
## which the reference calls m1, mx1, ..., Izz3
function A = others (m, ref)
  [K, names] = deal ([], {});
  words = {"m", "mx", "my", "mz", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz"};
  for link = 1:3
    names = [names, strcat(words, num2str (link))];
  end
  K = zeros (15, 30);
  for k = 1:15
    K(k,strcmp (names, ref.base_parameters{k})) = 1;
    if (isfield (ref.regrouping, ref.base_parameters{k}))
      for pair = ref.regrouping.(ref.base_parameters{k})'
        K(k,strcmp (names, pair{1}{1})) = str2double (pair{1}{2});
      end
    end
  end
  own = {"m", "hx", "hy", "hz", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz"};
  A = zeros (15, 30);
  rows_ = m.json.base_parameters;
  for k = 1:15
    list = rows_(k).standard;
    for j = 1:numel (list)
      link = list(j).name(5);
      at = strcmp (names, [words{strcmp(own, list(j).name(7:end))} link]);
      A(k,at) = evaluated (list(j), m);
    end
  end
  A = A * pinv (K);
end

function x = evaluated (row, m)
  text = row.value;
  if (! isempty (row.parameters))
    list = cellstr (row.parameters);
    for k = numel (list):-1:1
      text = regexprep (text, ['(?<!\w)p' num2str(k) '(?!\w)'], ...
                        sprintf ("(%.17g)", m.par.(list{k})));
    end
  end
  x = eval (text);
end

## ordinary and weighted least squares of rows that this test makes itself
function by_hand (m, d)
  [A, b] = deal ([]);
  for k = 1:numel (d.t)
    [Y, ~, r] = m.reg (d.t(k), d.q(k,:)', d.u(k,:)', d.ud(k,:)', []);
    [A, b] = deal ([A; Y], [b; d.tau(k,:)' - r]);
  end
  e = gsmbp_identify (m, d);
  p = lscov (A, b);
  gsmbp_check ("ordinary least squares", norm (e.p - p) / norm (p), 1e-12);
  rest = b - A * p;
  s2 = sumsq (rest) / (numel (b) - 15);
  gsmbp_check ("its standard deviations", e.sigma ./ sqrt (s2 * diag (inv (A' * A))) - 1, 1e-9);
  s = sqrt (sumsq (reshape (rest, 3, [])') / (numel (d.t) - 5));
  e = gsmbp_identify (m, d, "weights", "residual");
  w = repmat (1 ./ s', numel (d.t), 1);
  p = lscov (w .* A, w .* b);
  gsmbp_check ("weighted by what is left", norm (e.p - p) / norm (p), 1e-12);
  gsmbp_check ("condition numbers", [e.condition / cond(w .* A), e.condition_scaled ...
               / cond(w .* A ./ norm (w .* A, "columns"))] - 1, 1e-10);
end

## the estimates of the case are those of bodies already; link 1 of the model is none
function consistent_puma (m, d)
  e = gsmbp_identify (m, d, "sigma", [0.5 0.8 0.2]);
  old = warning ("off", "gsmbp:consistent", "local");
  c = gsmbp_consistent (m, e);
  gsmbp_check ("D5a: consistent estimates", (c.p - e.p) ./ e.sigma, 0.1);
  gsmbp_check ("D5a: pseudo-inertias are positive definite", [c.links.least] > 1e-6);
  v = gsmbp_validate (m, c, d);
  gsmbp_check ("D5a: the rms of what is left is as large as the noise", ...
               v.rms ./ [0.5 0.8 0.2] - 1, 0.15);
end

function more_columns (m, d)
  d.tau += [0.7 0.3] .* sign (d.u) + [0.1 -0.2];
  d.tau(:,2) += 0.02 * d.ud(:,2);
  e = gsmbp_identify (m, d, "coulomb", true, "offset", true, "fixed", "elbow_friction");
  gsmbp_check ("dry friction and offsets: names", strcmp (e.names(end-3:end), ...
               {"q1_coulomb"; "q2_coulomb"; "q1_offset"; "q2_offset"}));
  gsmbp_check ("a fixed friction is not estimated", ! any (strcmp (e.names, "elbow_friction")));
  gsmbp_check ("dry friction and offsets", e.p(end-3:end) - [0.7; 0.3; 0.1; -0.2], 0.2);
  d.tau(:,2) -= 0.02 * d.ud(:,2);
  e = gsmbp_identify (m, d, "coulomb", true, "offset", {"q1", "q2"});
  gsmbp_check ("dry friction and offsets, exact data", [e.p(end-3:end) - [0.7; 0.3; 0.1; -0.2]; ...
               e.p(1:end-4) - e.nominal(1:end-4)], 1e-12);
  v = gsmbp_validate (m, e, setfield (ident_motion (m, 40, 2), "tau", zeros (40, 2)));
  other = ident_motion (m, 40, 2);
  tau = other.tau + [0.7 0.3] .* sign (other.u) + [0.1 -0.2];
  gsmbp_check ("another motion, predicted", v.predicted - tau, 1e-11);
  gsmbp_check ("what the model says", v.nominal - other.tau, 1e-12);
end

## K, R, L of both motors with the base parameters, from currents and voltages alone
function motor_constants (m, d)
  [K, R, L, n] = deal ([0.1 0.05], [2 3], [0.01 0.02], [50 -30]);
  i = d.tau ./ (n .* K);
  id = zeros (size (i));
  for k = 1:numel (d.t)   # i' is a number like any other here
    id(k,:) = sin (k + [1 2]);
  end
  v = R .* i + n .* K .* d.u + L .* id;
  d.tau = [];
  d.other = struct ("i1", i(:,1), "i2", i(:,2), "v1", v(:,1), "v2", v(:,2));
  d.other_d = struct ("i1", id(:,1), "i2", id(:,2), "v1", 0, "v2", 0);
  motors = struct ("coordinate", {"q1", "q2"}, "ratio", num2cell (n), "current", {"i1", "i2"}, ...
                   "voltage", {"v1", "v2"}, "inductance", true);
  e = gsmbp_identify (m, d, "motors", motors);
  gsmbp_check ("motors: names", strcmp (e.names(end-5:end), ...
               {"q1_K"; "q1_R"; "q1_L"; "q2_K"; "q2_R"; "q2_L"}));
  gsmbp_check ("motors: K, R, L", e.p(end-5:end) - [K; R; L](:), 1e-11);
  base = isfinite (e.nominal);
  gsmbp_check ("motors: base parameters", e.p(base) - e.nominal(base), 1e-10);
  fail ("gsmbp_identify (m, d, \"motors\", motors(1))", ...
        "data.tau: expected 60 x 2 finite numbers");
  motors(1).current = "i3";
  fail ("gsmbp_identify (m, d, \"motors\", motors)", ...
        "current of motor 1: unknown column \"i3\"");
end

function not_told_apart (m, d)
  d.q(:,2) = 1;
  [d.u(:,2), d.ud(:,2)] = deal (0);
  gsmbp_check ("an axis that stands still: what the data do not tell", ! isempty (strfind ( ...
    complaint (@() gsmbp_identify (m, d)), "the data do not depend on elbow_friction: fix it")));
  said = complaint (@() gsmbp_identify (m, ident_motion (m, 60, 0), "rotor", "q1"));
  gsmbp_check ("... and what they do not tell apart", ! isempty (regexp (said, ...
               "the data do not tell upper_IzzR, q1_rotor apart .condition")));
end

function said = complaint (f)
  said = "";
  try
    f ();
  catch err
    said = err.message;
  end
end

## data of a body that cannot be: the estimates are moved, the conditions of a minimum hold
function consistent (m, d)
  s = [0.3 0.1];
  e = gsmbp_identify (m, d, "sigma", s);
  c = gsmbp_consistent (m, e);
  gsmbp_check ("exact data: nothing to gain", c.gain, 1e-3);
  impossible = gsmbp_identify (m, d, "sigma", s);
  k = strcmp (e.names, "fore_IzzR") | strcmp (e.names, "fore_Izz");
  gsmbp_check ("the inertia about the elbow is there", sum (k) == 1);
  impossible.p(k) = -0.01;
  impossible.z = impossible.R * impossible.p;
  c = gsmbp_consistent (m, impossible);
  gsmbp_check (sprintf ("an inertia of -0.01: %.4g now, chi2 gains %.4g in %d steps", c.p(k), ...
                        c.gain, c.iterations), [c.p(k) > 0, c.gain > 1]);
  gsmbp_check ("pseudo-inertias are positive definite", [c.links.least] > 0);
  ## I = trace (Sigma)*1 - Sigma about the centre: triangle inequality
  for l = c.links
    i = eig (l.inertia);
    gsmbp_check (["moments of " l.name], [l.mass > 0, i(3) < i(1) + i(2)]);
  end
  smaller = gsmbp_consistent (m, impossible, "gap", 0.01);
  gsmbp_check ("a smaller gap: less misfit, hardly", [smaller.gain < c.gain, ...
               smaller.gain > 0.999 * c.gain]);
  minimum (m, impossible, c);
end

## the gradient at the minimum, by differences of the function as its definition says it
function minimum (m, e, c)
  list = m.json.standard_parameters;
  x0 = arrayfun (@(row) evaluated (row, m), list(:));
  K = zeros (numel (c.p), numel (x0));
  for k = 1:numel (c.p)
    for row = m.json.base_parameters(k).standard(:)'
      K(k,strcmp ({list.name}, row.name)) = evaluated (row, m);
    end
  end
  gsmbp_check ("the estimates are those of the standard parameters", K * c.standard - c.p, 1e-12);
  g = c.gap / 10;   # 4 eigenvalues of 2 links, 2 frictions
  slope = zeros (numel (x0), 1);
  for k = 1:numel (x0)   # a step along the imaginary axis: no difference is taken
    size_of = max (abs (c.standard(k)), 1e-3);
    h = 1e-20i * (1:numel (x0) == k)';
    slope(k) = imag (divergence (e, K, c.standard + h, x0, g)) / 1e-20 * size_of;
  end
  gsmbp_check ("the gradient there vanishes, over g", slope / g, 1e-3);
end

function f = divergence (e, K, x, x0, g)
  miss = e.R * (K * x) - e.z;
  f = miss.' * miss / 2;
  for first = [1, 11]
    [P, P0] = deal (pseudo (x(first:first+9)), pseudo (x0(first:first+9)));
    f += g * (trace (P0 \ P) - log (det (P0 \ P)) - 4);
  end
  f += g * sum (x(21:22) ./ x0(21:22) - log (x(21:22)));
end

function P = pseudo (a)
  I = [a(5) a(8) a(9); a(8) a(6) a(10); a(9) a(10) a(7)];
  P = [trace(I)/2*eye(3) - I, a(2:4); a(2:4).', a(1)];
end

function written_back (m, d)
  e = gsmbp_identify (m, d, "sigma", [0.3 0.1]);
  off = gsmbp_set (m, "m2", 1.5, "c2", 0.18, "d1", 0.1);
  e2 = gsmbp_identify (off, d, "sigma", [0.3 0.1]);
  file = [tempname() ".csv"];
  [back, table, misfit] = gsmbp_adopt (off, e2, {"m2", "c2", "j2", "d1", "d2", "j1", "m1"}, ...
                                       "file", file);
  text = fileread (file);
  delete (file);
  gsmbp_check ("written back: the base parameters", gsmbp_identify (back, d).nominal - e.p, 1e-8);
  gsmbp_check ("... by the largest miss", misfit, 1e-6);
  k = strcmp ({table.name}, "d1");
  gsmbp_check ("... friction", table(k).value - 0.4, 1e-8);
  gsmbp_check ("... its deviation", table(k).sigma / e.sigma(strcmp (e.names, ...
               "shoulder_friction")) - 1, 0.02);
  gsmbp_check ("... what was there before", table(k).before == 0.1);
  gsmbp_check ("... the file", strncmp (text, "name,value,sigma,before,determined\nm2,", 38));
  gsmbp_check ("a length is not adopted", ! isempty (strfind (complaint (@() gsmbp_adopt (off, ...
    e2, {"m2", "l1"})), "parameter l1 is in the factors of the base parameters")));
  gsmbp_check ("units of friction", strcmp (e2.units{end}, "N*m*s/rad"));
  gsmbp_check ("mass and inertia of the upper link are not told apart", ...
               ! [table(strcmp ({table.name}, "m1")).determined]);
end
