# The units of tables that Octave reads are those of scenes: each word of library/units.mac has the
# same factor to SI units and the same powers of kg, m, s, A, K in octave/+gs/+text/unit_in_si.m;
# units composed of several words against their definitions.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
share/make/maxima "$work/log" "load(\"$PWD/gsmbp/gsmbp.mac\")\$
  with_stdout(\"$work/units\", for u in gs__unit_symbols() do block([e : gs__unit(u), f, n],
    f : subst(map(lambda([r], first(r) = 1), gs__si_units), e),
    n : apply(\"+\", cons([0, 0, 0, 0, 0], map(lambda([r], second(r)*hipow(e, first(r))),
      gs__si_units))),
    if not freeof(%pi, f) or numberp(f) then f : bfloat(f),
    if u = 'rpm then n : [0, 0, -1, 0, 0],
    print(u, float(f), simplode(n, \" \"))))\$"
words=$(wc -l <"$work/units")
check "Maxima tells its units: $words" test "$words" -gt 80
octave-cli -qf --no-history --path octave --eval "
  f = fopen ('$work/units');
  c = textscan (f, '%s %f %f %f %f %f %f');
  for k = 1:numel (c{1})
    word = c{1}{k};
    [factor, powers, unknown] = gs.text.unit_in_si (word);
    wanted = [c{3}(k), c{4}(k), c{5}(k), c{6}(k), c{7}(k)];
    good = isempty (unknown) && abs (factor / c{2}(k) - 1) < 1e-15 && isequal (powers, wanted);
    printf ('%s %s\n', {'not ok', 'ok'}{1 + good}, word);
  end
  composed = {'m/s', 1, [0 1 -1 0 0]; '1/s', 1, [0 0 -1 0 0]; 'km/hour', 1/3.6, [0 1 -1 0 0]
              '1/min/mm', 1000/60, [0 -1 -1 0 0]; 'kg*m/s^2', 1, [1 1 -2 0 0]
              'N*m/A', 1, [1 2 -2 -1 0]; 'V*s/rad', 1, [1 2 -2 -1 0]
              'g*cm^2', 1e-7, [1 2 0 0 0]; 'J/kg/K', 1, [0 2 -2 0 -1]
              'l/min', 1e-3/60, [0 3 -1 0 0]; 'kg/m*s^-1', 1, [1 -1 -1 0 0]};
  for row = composed'
    [factor, powers, unknown] = gs.text.unit_in_si (row{1});
    good = isempty (unknown) && abs (factor / row{2} - 1) < 1e-15 && isequal (powers, row{3});
    printf ('%s %s: expected %.17g and powers [%s], found %.17g, [%s]\n', ...
            {'not ok', 'ok'}{1 + good}, row{1:2}, num2str (row{3}), factor, num2str (powers));
  end"
