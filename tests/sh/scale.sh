# Scenes of 128 links: derived, emitted, compiled and run; the efforts of the inverse dynamics are those of Newton and Euler in ground axes
# (tests/tools/scale.mac). Both sum in double precision, in another order: 1e-13 of the largest effort leaves a factor of a hundred.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for kind in spat tree pend; do
  share/make/maxima "$work/log" "load(\"gsmbp/gsmbp.mac\")\$ load(\"tests/tools/scale.mac\")\$
    gsmbp_fortran(scale_scene(\"$kind\", 128), [inverse], ['directory = \"$work\"])\$
    scale_driver(\"$kind\", 128, \"$work/driver.f\")\$" &&
    (cd "$work" && gfortran -O0 -o run "${kind}128.f" driver.f "$OLDPWD/share/fortran/gsfin.f" "$OLDPWD/share/fortran/gssc.f" "$OLDPWD/share/fortran/gsscl.f" && ./run) >"$work/out" 2>&1
  awk -v what="$kind: 128 links, efforts" '{ print; if ($1 == "ERROR") good = $2 < 1e-13 } END { print (good ? "ok " : "not ok ") what }' "$work/out"
done
