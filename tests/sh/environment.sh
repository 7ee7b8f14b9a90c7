# What is derived and emitted does not depend on the options, facts and declared properties of the
# session, and they are afterwards as they were; what cannot be put aside is one error.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cat >"$work/scenes.mac" <<'M'
load("tests/maxima/session.lisp")$ load("tests/maxima/hostile.lisp")$
arm() := gsmbp_scene("arm", gravity = [0, -g, 0],
  link(a, mass = m1, centre = [0.1, 0.2, 0], inertia = [1, 2, 3]),
  link(b, mass = 2, centre = [0.3, 0.1, d0], inertia = [0.3, 0.4, 0.5]),
  revolute(J1, ground, a, axis = z, coordinate = q1),
  revolute(J2, a, b, at = [0.5, 0.1, 0], axis = [3/5, 0, 4/5], coordinate = q2, friction = 0.3),
  input(f, unit = N),
  force(F, b, vector = [f, exp(-t), sqrt(2)], frame = ground),
  dc_motor(M1, joint = J1, ratio = 9),
  output(y, atan2(sin(q1), cos(q2)), unit = rad),
  parameters = [g = 9.81*m/s^2, m1 = 3*kg, d0 = 0])$
loop() := block([scene], load("tests/scenes/case_02a_motor.mac"), scene)$
emit(folder, s, requests) :=
  (gsmbp_fortran(s, requests, directory = sconcat(work, "/", folder)), 'done)$
emitted(folder, name, e) := sconcat(work, "/", folder, "/", name, e)$
same(folder, name) := every(
  lambda([e], same_bytes(emitted("plain", name, e), emitted(folder, name, e))), [".f", ".json"])$
told(what, good) := printf(true, "~a ~a~%", if good then "ok" else "not ok", what)$
M
prelude="work : \"$work\"\$ load(\"gsmbp/gsmbp.mac\")\$ batchload(\"$work/scenes.mac\")\$"

share/make/maxima "$work/log" "$prelude
emit(\"plain\", arm(), [inverse, rhs])\$ emit(\"plain\", loop(), [rhs, jacobian, command])\$
options : hostile_options()\$ scene1 : arm()\$ scene2 : loop()\$
told(\"there are options to turn round\", length(options) > 100)\$
/* many at once */
for k thru 2 do block([l : makelist(options[i], i, k, length(options), 2), r],
  r : errcatch(with_hostile(l, emit(\"many\", scene1, '[inverse, rhs]))),
  told(sconcat(\"options, part \", k, \": the same bytes\"), r # [] and same(\"many\", \"arm\")),
  told(sconcat(\"options, part \", k, \": as they were\"), r # [] and second(first(r)) = []))\$
block([r : errcatch(with_hostile(options, emit(\"all\", scene2, '[rhs, jacobian, command])))],
  told(\"all options, a scene with a loop and a motor: the same bytes, as they were\",
    r # [] and second(first(r)) = [] and same(\"all\", \"case_02a_motor\")))\$
" || echo "not ok options: $(tail -n 1 "$work/log")"
grep -E '^(not )?ok ' "$work/log"

# one at a time, as a user sets them: word, value; in both the scene is read and derived
one() {
  cat <<M
block([r : errcatch(block([$1 : $2], emit("one", arm(), [inverse, rhs])))],
  told("$1 = $2: the same bytes", r # [] and same("one", "arm")))\$
M
}
{
  for o in exponentialize numer float demoivre halfangles trigexpand keepfloat algebraic ratfac \
    bftorat; do one $o true; done
  for o in negdistrib radexpand logexpand doallmxops trigsign simp listarith %emode; do
    one $o false
  done
  one obase 16; one ibase 8; one domain "'complex"; one radexpand "'all"; one logexpand "'super"
  one expop 3; one fpprec 60; one fpprintprec 4
} >"$work/ones.mac"
share/make/maxima "$work/log" "$prelude
emit(\"plain\", arm(), [inverse, rhs])\$ snapshot : session_snapshot()\$
batchload(\"$work/ones.mac\")\$
told(\"options one at a time: the session is as it was\", session_changes(snapshot) = [])\$" ||
  echo "not ok options one at a time: $(tail -n 1 "$work/log")"
grep -E '^(not )?ok ' "$work/log"

# loaded under hostile options; facts, declared properties, derivatives; an error in between
share/make/maxima "$work/log" "work : \"$work\"\$
declare(q1, constant, m1, mainvar, q2, integer, f, nonscalar, d0, bindtest, J1, scalar)\$
depends(q1, t, q2, t)\$ gradef(m1, t, 7)\$ assume(q1_d > 0, q2 > 0, m1 < 0)\$
matchdeclare(mm, true)\$ tellsimpafter(foo(mm), 7)\$ gradef(bar(x), 7)\$
newcontext(mine)\$ assume(q1 < 0)\$ context : 'initial\$ activate(mine)\$
load(\"tests/maxima/session.lisp\")\$
numer : true\$ exponentialize : true\$ obase : 12\$ ibase : 8\$
load(\"gsmbp/gsmbp.mac\")\$ obase : 12\$ ibase : 12\$ numer : false\$
batchload(\"$work/scenes.mac\")\$
what_holds() := [facts(), facts(mine), activecontexts, context, properties(q1), properties(m1)]\$
before : what_holds()\$ snapshot : session_snapshot()\$
emit(\"facts\", arm(), [inverse, rhs])\$ errcatch(gsmbp_scene(\"bad\", link(a, mas = 1)))\$
told(\"facts, properties, derivatives: the same bytes\", same(\"facts\", \"arm\"))\$
told(\"facts, properties, derivatives: as they were\", what_holds() = before)\$
told(\"facts, properties, derivatives: the session is as it was\",
  session_changes(snapshot) = [])\$" ||
  echo "not ok facts: $(tail -n 1 "$work/log")"
grep -E '^(not )?ok ' "$work/log"

# what is in the way is one error, and nothing else is touched
refused() {
  share/make/maxima "$work/log" "$prelude $1\$
    text() := ssubst(\"\", \"\\\\\", string(first(error)))\$
    block([errormsg : false, r], r : errcatch(emit(\"rules\", arm(), [inverse])),
      told(\"$2\", r = [] and ssearch(\"expected a session without $3\", text()) # false))\$"
  grep -E '^(not )?ok ' "$work/log" || echo "not ok $2: $(tail -n 1 "$work/log")"
}
refused 'matchdeclare(aa, true), tellsimpafter(aa*zz9, 7)' 'a rule on a product is refused' \
  'rules of tellsimp on'
refused 'gradef(sin(x), 7)' 'a derivative of sin is refused' 'a gradef of sin'
refused 'ordergreat(m1, q1)' 'an order of symbols is refused' 'an order of symbols'
