## Tolerances below what the precision of a build can keep: raised, with a warning, in every
## integrator that has them; runs with absurd ones end soon. What is no tolerance is an error.

function test_tolerances ()
  m = gsmbp_hand ("motor_pendulum");
  q = gsmbp_hand ("motor_pendulum", "precision", "quad");
  floors (m, "dp853", 10 * eps);
  floors (m, "cvode", 100 * eps);
  floors (q, "dp853", 10 * 2 ^ -112);
  gsmbp_check ("a build in quad keeps 1e-20 without a word", ...
               isempty (warned (@() gsmbp_simulate (q, [1; 0; 0], [0, 0.1], "rtol", 1e-20))));
  gsmbp_check ("rk4 has no tolerance to raise", ...
               isempty (warned (@() gsmbp_simulate (m, [1; 0; 0], [0, 0.1], "method", "rk4", ...
                                  "rtol", 1e-20))));
  absurd ({m, gsmbp_hand("hand_crank"), gsmbp_fixture("rolling_disc")});
  wrong (m);
end

function floors (m, method, least)
  run = @(varargin) gsmbp_simulate (m, [1; 0; 0], [0, 0.1], "method", method, varargin{:});
  for given = {{"rtol", 1e-40}, {"rtol", 1e-8, "atol", 0}, {"rtol", 1e-8, "atol", 1e-50}, ...
               {"rtol", 1e-8, "atol", [1e-6, 0, 1e-6]}, {"rtol", 1e-300, "atol", 1e-300}}
    text = warned (@() run (given{1}{:}));
    warning ("off", "gsmbp:tolerance", "local");
    s = run (given{1}{:}).stats;
    gsmbp_check (sprintf ("%s, %s: %s: raised with a warning", m.precision, method, ...
                          mat2str (given{1}{end}, 3)),
                 ! isempty (strfind (text, "is below what")) && s.rtol >= least * (1 - 1e-12) ...
                     && all (s.atol >= least * m.nominal * (1 - 1e-9)));
  end
  gsmbp_check ([m.precision ", " method ": what can be kept is not raised"], ...
               isempty (warned (@() run ("rtol", 2 * least))) ...
                 && abs (run ("rtol", 2 * least).stats.rtol / least - 2) < 1e-12);
end

## calls with a tolerance of 1e-20, of 0 for the smallest states, beside those at 1e-14
function absurd (models)
  warning ("off", "gsmbp:tolerance", "local");
  for k = 1:numel (models)
    m = models{k};
    x = gsmbp_assemble (m, m.initial);
    usual = gsmbp_simulate (m, x, [0, 1], "rtol", 1e-14).stats.calls;
    for given = {{"rtol", 1e-20}, {"rtol", 1e-20, "atol", 0}, {"atol", 0}, {"atol", 1e-30}}
      [r, info] = gsmbp_simulate (m, x, [0, 1], given{1}{:}, "maxsteps", 1e5);
      gsmbp_check (sprintf ("%s: %d calls with absurd tolerances, %d at 1e-14", m.name, ...
                            r.stats.calls, usual), info == 0 && r.stats.calls <= 2 * usual);
    end
  end
end

function text = warned (f)
  lastwarn ("", "");
  state = warning ("on", "gsmbp:tolerance", "local");
  evalc ("f ();");
  [text, id] = lastwarn ();
  if (! strcmp (id, "gsmbp:tolerance"))
    text = "";
  end
end

function wrong (m)
  for value = {-1e-6, NaN, Inf, 0, 1, 2, [1e-6, 1e-6, 1e-6], 1e-6i, "tight", {}, []}
    says (m, "rtol", value{1}, "option rtol: expected a number above 0 and below 1, found ");
  end
  for value = {-1e-6, NaN, Inf, [1e-6, 1e-6], [1, -1, 1], 1e-6i, "tight", {1, 2, 3}}
    says (m, "atol", value{1}, ...
          "option atol: expected one number or 3 numbers, finite and >= 0, found ");
  end
end

function says (m, name, value, text)
  found = "no error";
  try
    gsmbp_simulate (m, [1; 0; 0], [0, 0.1], name, value);
  catch err
    found = err.message;
  end
  if (! gsmbp_check (sprintf ("%s = %s: message", name, ...
                              strtrim (strrep (disp (value), "\n", " "))), ...
                     strncmp (found, ["gsmbp_simulate: " text], numel (text) + 16)))
    printf ("  found: %s\n", found);
  end
end
