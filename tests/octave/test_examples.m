## The tables of the two examples (their drivers have run) against numbers computed elsewhere, to all digits that were printed.

function test_examples ()
  puma ();
  slider_crank ();
end

function tab = table (example, file)
  name = fullfile (fileparts (mfilename ("fullpath")), "..", "..", "examples", example, "out", file);
  lines = strsplit (strtrim (fileread (name)), "\n");
  values = dlmread (name, ",", 1, 0);
  heads = strtrim (strsplit (strrep (lines{1}, '"', ''), ","));
  for k = 1:numel (heads)
    tab.(heads{k}) = values(:, k);
  end
end

## rows of t, one being wanted at most 1e-9 away
function i = row (tab, t)
  i = find (abs (tab.t - t) < 1e-9);
end

function puma ()
  tab = table ("puma560", "inverse_dynamics.csv");
  wanted = [0,    0,        24.8836, 0.8155,  -0.0257,  1.6509,  0.0956
            0.25, -11.4742, 48.9241, -2.8317, -8.7933,  22.6358, -7.0982
            0.5,  -7.6870,  43.8232, -2.9166, -14.1722, 37.4071, -12.3459
            0.75, 6.8346,   23.2143, -0.5373, -6.7128,  20.9431, -6.8039
            1,    0,        31.9398, 0,       -0.0379,  2.1134,  -0.0053];
  for k = 1:rows (wanted)
    i = row (tab, wanted(k, 1));
    found = [tab.tau1(i), tab.tau2(i), tab.tau3(i), tab.v1(i), tab.v2(i), tab.v3(i)];
    gsmbp_check (sprintf ("PUMA efforts and voltages at t = %g s, four printed decimals", wanted(k, 1)), found - wanted(k, 2:end), 0.5001e-4);
  end
  gsmbp_check ("PUMA columns of inverse_dynamics.csv", isequal (fieldnames (tab)', {"t", "q1", "q2", "q3", "tau1", "tau2", "tau3", "v1", "v2", "v3"}));
  gsmbp_check ("PUMA rows at least every 0.01 s", diff (tab.t), 0.01 + 1e-9);
  gsmbp_check ("PUMA tau1(0) = 0", tab.tau1(1), 1e-12);
  gsmbp_check ("PUMA tau2(0), tau3(0) carry the weight", all (abs ([tab.tau2(1), tab.tau3(1)]) > 0.5));
  related = @(a, b) corr (a, b);
  found = [related(tab.tau1, tab.v1), related(tab.tau2, tab.v2), related(tab.tau3, tab.v3)];
  gsmbp_check ("PUMA voltage is not proportional to effort (correlation)", found, 0.9);

  open = table ("puma560", "open_loop.csv");
  gsmbp_check ("PUMA columns of open_loop.csv", isequal (fieldnames (open)', {"t", "q1", "q2", "q3", "e1", "e2", "e3"}));
  gsmbp_check ("PUMA open-loop deviation, rad (the paper's figure: 7e-3)", [open.e1, open.e2, open.e3], 7e-3);
end

function slider_crank ()
  tab = table ("slider_crank", "inverse_dynamics.csv");
  gsmbp_check ("slider-crank columns of inverse_dynamics.csv", isequal (fieldnames (tab)', {"t", "omega_crank", "omega_rod", "tau", "v"}));
  gsmbp_check ("slider-crank rows at least every 0.01 s", diff (tab.t), 0.01 + 1e-9);
  wanted = [0.5, 3.017812, 3.4535; 1.5, -1.751477, 15.7935; 2.5, 2.222774, 19.4894; 3, -1.037545, 18.3200; 5, -2.658148, 17.7720];
  for k = 1:rows (wanted)
    i = row (tab, wanted(k, 1))(1);
    gsmbp_check (sprintf ("slider-crank torque at t = %g s, six printed decimals", wanted(k, 1)), tab.tau(i) - wanted(k, 2), 0.5001e-6);
    gsmbp_check (sprintf ("slider-crank voltage at t = %g s, four printed decimals", wanted(k, 1)), tab.v(i) - wanted(k, 3), 0.5001e-4);
  end
  i = row (tab, 1);   # the acceleration has a kink there: the voltage jumps from 10.4789 to 10.4774
  gsmbp_check ("slider-crank torque at t = 1 s", tab.tau(i) - 2.899184, 0.5001e-6);
  gsmbp_check ("slider-crank voltage before or after the kink at 1 s", min (abs (tab.v(i) - [10.4789, 10.4774]), [], 2), 0.5001e-4);
  gsmbp_check ("slider-crank crank and rod speed stay in the paper's figure", [max(tab.omega_crank) / 4, max(abs (tab.omega_rod)) / 1.605], 1 + 1e-9);

  open = table ("slider_crank", "open_loop.csv");
  gsmbp_check ("slider-crank columns of open_loop.csv", isequal (fieldnames (open)', {"t", "omega_nominal", "omega", "drift"}));
  gsmbp_check ("slider-crank loop stays closed in open loop, m", open.drift, 1e-9);
end
