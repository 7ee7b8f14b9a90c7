# Scenes of 128 links: derived, emitted, compiled and run; the efforts of the inverse dynamics are
# those of Newton and Euler in ground axes (tests/tools/scale.mac), and the accelerations of the
# forward dynamics need these efforts. Both sum in double precision, in another order: 1e-13 of the
# largest effort leaves a factor of a hundred.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for kind in spat tree pend; do
  share/make/maxima "$work/log" "load(\"gsmbp/gsmbp.mac\")\$ load(\"tests/tools/scale.mac\")\$
    gsmbp_fortran(scale_scene(\"$kind\", 128), [inverse, forward], ['directory = \"$work\"])\$
    scale_driver(\"$kind\", 128, \"$work/driver.f\")\$" &&
    (cd "$work" && gfortran -O0 -o run "${kind}128.f" driver.f "$OLDPWD/share/fortran/gsfin.f" "$OLDPWD/share/fortran/gssc.f" "$OLDPWD/share/fortran/gsscl.f" && ./run) >"$work/out" 2>&1
  awk -v what="$kind: 128 links" '{ print; if ($1 == "ERROR") inverse = $2 < 1e-13; if ($1 == "FORWARD") forward = $2 < 1e-13 }
    END { print (inverse ? "ok " : "not ok ") what ", efforts"; print (forward ? "ok " : "not ok ") what ", accelerations" }' "$work/out"
done
