# Maxima on another Lisp (Debian's maxima-sage is built on ECL, maxima on GCL) derives the same
# text, byte by byte.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
one=${MAXIMA:-maxima}
other=maxima-sage
[ "$one" = maxima-sage ] && other=maxima
for name in case_01a case_03a electric_arms fluid_hydraulic sampled_crank redundant_tilted orient_angles; do
  MAXIMA=$other GSMBP_TIMEOUT=300 share/make/derive "tests/scenes/$name.mac" "$work" &&
    cmp "$GSMBP_TEST_DIR/fortran_out/$name.f" "$work/$name.f" && cmp "$GSMBP_TEST_DIR/fortran_out/$name.json" "$work/$name.json" &&
    echo "ok $name: $one and $other derive the same" || echo "not ok $name: $one and $other derive the same"
done
