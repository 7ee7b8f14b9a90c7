# Scenes of 64 links, in make test-whole of 128, too: derived, emitted, compiled and run; efforts of
# the inverse dynamics are those of Newton and Euler in ground axes (tests/tools/scale.mac), and the
# accelerations of the forward dynamics need these efforts. Both sum in double precision, in another
# order: 1e-13 of the largest effort leaves a factor of a hundred.
. tests/tools/check.sh
functions=$PWD/share/fortran/functions
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for scene in $(whole && echo spat128 || echo spat64) tree64 pend64; do
  kind=${scene%%[0-9]*} links=${scene#????}
  : >"$work/out"
  share/make/maxima "$work/log" "load(\"gsmbp/gsmbp.mac\")\$ load(\"tests/tools/scale.mac\")\$
    gsmbp_fortran(scale_scene(\"$kind\", $links), [inverse, forward], ['directory = \"$work\"])\$
    scale_driver(\"$kind\", $links, \"$work/driver.f\")\$" &&
    (cd "$work" && gfortran -O0 -o run "$scene.f" driver.f \
      "$functions/gsfin.f" "$functions/gssc.f" "$functions/gsscl.f" \
        "$functions/gsscv.f" && ./run) >"$work/out" 2>&1
  for what in ERROR:efforts FORWARD:accelerations; do
    awk -v word="${what%:*}" '$1 == word { good = $2 < 1e-13 } END { exit !good }' "$work/out"
    told $? "$kind: $links links, ${what#*:}" "$work/out"
  done
done
