# Ctrl-C in a derivation (SIGINT to the session and the processes that it has started, as a terminal
# sends it): the session answers, nothing is half-written, and the next derivation writes what a
# fresh session writes.
. tests/tools/check.sh
root=$PWD
work=$(mktemp -d)
maxima=
trap '[ -z "$maxima" ] || kill -KILL "-$maxima" 2>/dev/null; rm -rf "$work"' EXIT
say() { told "$2" "$1" "$work/log"; }
# waits until the log holds a text, two minutes at most
until_said() {
  n=0
  while ! grep -q "$1" "$work/log" && [ $n -lt 600 ]; do sleep 0.2; n=$((n + 1)); done
  grep -q "$1" "$work/log"
}

mkfifo "$work/in"
setsid "${MAXIMA:-maxima}" --very-quiet <"$work/in" >"$work/log" 2>&1 &
maxima=$!
exec 3>"$work/in"
mkdir "$work/cut" "$work/whole" "$work/fresh"
load="load(\"$root/gsmbp/gsmbp.mac\")\$ load(\"$root/tests/bench/systems/spat5.mac\")\$"
echo "$load print(\"RE\",\"ADY\")\$" >&3
until_said 'RE ADY'; say 'the session begins' $?
hundred="for k thru 100 do gsmbp_fortran(scene, all, directory = \"$work/cut\")"
echo "print(\"BE\",\"GUN\")\$ $hundred\$" >&3
until_said 'BE GUN'
sleep 1
kill -INT "-$maxima"
echo "print(\"AL\",\"IVE\")\$" >&3
# a hundred derivations would take longer than until_said waits
until_said 'AL IVE'; say 'the session answers after an interrupt' $?
# ten more, at other moments, within an errcatch, too: none is taken for a failure of something else
for k in 1 2 3 4 5 6 7 8 9 10; do
  echo "print(\"BE\",\"GUN $k\")\$ errcatch($hundred)\$" >&3
  until_said "BE GUN $k"
  sleep 0.$((k * 97 % 89 + 10))
  kill -INT "-$maxima"
  echo "print(\"AL\",\"IVE $k\")\$" >&3
  until_said "AL IVE $k" || break
done
until_said 'AL IVE 10'; say 'it answers after ten more' $?
[ "$(grep -ciE 'interrupt' "$work/log")" -ge 11 ] && ! grep -qE 'unsuitable|-- an error' "$work/log"
say 'each is told as an interrupt' $?
! ls "$work"/cut/*tmp >/dev/null 2>&1; say 'nothing half-written' $?
echo "gsmbp_fortran(scene, all, directory = \"$work/whole\")\$ print(\"DO\",\"NE\")\$" >&3
until_said 'DO NE'
exec 3>&-
share/make/maxima "$work/fresh/log" "$load gsmbp_fortran(scene, all, directory = \"$work/fresh\")\$"
for part in f json; do
  cmp "$work/whole/spat5.$part" "$work/fresh/spat5.$part"
  say "spat5.$part: what a fresh session writes" $?
done
