# A routine is added by a row of gs__request_rows and its specification: tests/data/toy.diff does so
# in a copy (KEN, the kinetic energy alone); its handle in Octave is there by itself.
. tests/tools/check.sh
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=$work/out

cp -R gsmbp octave share "$work"
check 'the diff of two files applies' \
  sh -c "cd '$work' && [ \$(grep -c '^diff' '$PWD/tests/data/toy.diff') = 2 ] &&
    patch -p1 <'$PWD/tests/data/toy.diff'" >>"$report" 2>&1
(cd "$work" && share/make/compile) >"$report" 2>&1
cp examples/slider_crank/slider_crank.mac "$work/toy.mac"
sed -i 's/"slider_crank"/"toy"/' "$work/toy.mac"
echo "requests : [kinetic, energy]\$" >>"$work/toy.mac"
check 'the routine is derived' sh -c "cd '$work' && share/make/derive toy.mac fortran_out" \
  >"$report" 2>&1
cat >"$work/toy.m" <<'A'
m = gsmbp_build ("toy");
q = [0.3; -0.2; 0.5]; u = [1; -2; 0.7];
e = m.ene (0, [q; u; 0.1]);
printf ("%d\n", abs (m.ken (0, q, u) - e(1)) <= 1e-14 * e(1) && e(1) > 0.1);
try
  m.ken (0, q);
catch problem
  printf ("%s\n", problem.message);
end
A
(cd "$work" && octave-cli -qf --path "$work/octave" toy.m) >"$work/said" 2>"$report"
sed 1q "$work/said" | grep -qx 1
told $? 'its handle gives the first of the energies' "$report"
grep -q 'toy.ken: argument u is missing; expected m.ken (t, q, u)' "$work/said"
told $? 'its handle says what it expects' "$work/said"
