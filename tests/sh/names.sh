# Every function of the package is defined once: Maxima would silently keep the last definition.
twice=$(grep -hoE '^ *gsmbp_[a-zA-Z_0-9]+\(' gsmbp/*.mac share/*/*.mac | tr -d ' ' | sort | uniq -d)
calls=''
for f in $twice; do
  n=$(grep -hE "^ *$(printf %s "$f" | sed 's/(/\\(/').*:=" gsmbp/*.mac share/*/*.mac | wc -l)
  [ "$n" -gt 1 ] && calls="$calls $f"
done
[ -z "$calls" ] && echo "ok no function is defined twice" || echo "not ok defined twice:$calls"
