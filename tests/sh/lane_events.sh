# EVT_W, the event functions of runs in lanes: vectorized; what EVT has under the same modes, at
# states by chance; the bits of a state are the same at every place, also beside bad ones, which it
# leaves to the caller. Scenes whose EVT is no straight line have none, and gsmbp_fortran says so.
. tests/tools/check.sh
. tests/tools/loops.sh
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit
report=$work/report

statements="load(\"$root/gsmbp/gsmbp.mac\")\$"
for name in event_joint event_crank lane_events lane_event_loop lane_event_pull user_section; do
  statements="$statements kill(requests)\$ load(\"$root/tests/scenes/$name.mac\")\$
    gsmbp_fortran(scene, [lanes], ['directory = \"$work\"])\$"
done
# one that is too long; a scene without events
statements="$statements
  block([gs__batch_limit : 1], gsmbp_fortran(scene, [events_w], ['directory = \"$work/none\"]))\$
  bare : gsmbp_scene(\"bare\", link(rod, mass = 1, inertia = [0, 0, 1]),
    revolute(A, ground, rod, axis = z, coordinate = q))\$
  gsmbp_fortran(bare, [lanes], ['directory = \"$work\"])\$"
"$root/share/make/maxima" "$work/log" "$statements"
told $? 'scenes with events in lanes' "$work/log"

cat >beside.f90 <<'F'
! NAME, NX, NV, NE, NCST, NPAR, PORTS (how many of the last inputs are modes) are put in
program beside
  implicit none
  integer, parameter :: n = 16, nx = NX, nv = NV, ne = NE, ports = PORTS
  double precision :: t(n), x(n,nx), v(n,max(nv,1)), par(max(NPAR,1)), cst(max(NCST,1))
  double precision :: c(n,max(NCST,1))
  double precision :: g(n,ne), h(n,ne), one(ne), off, by
  integer :: info(n), flags(n), mode(ne), i, k, way, good, fault
  logical :: same
  call random_seed(size = k)
  call random_seed(put = [(7919*i, i = 1, k)])
  call NAME_par(par)
  call NAME_pre(par, cst, fault)
  c = spread(cst, 1, n)
  off = 0; good = 0; same = .true.
  do way = 1, 200
    call random_number(t); call random_number(x); call random_number(v)
    x = 2*x - 1; v = 6*v - 3
    do i = nv - ports + 1, nv   ! the modes
      v(:,i) = nint(v(:,i)/3.2d0)
    end do
    call NAME_evt_w(t, x, v, c, g, info, n, n)
    do i = 1, n
      if (info(i) /= 0) cycle
      good = good + 1
      mode = 0
      mode(:ports) = nint(v(i,nv-ports+1:nv))
      call NAME_evt(t(i), x(i,:), v(i,:), mode, cst, one)
      do k = 1, ne
        by = 1 + abs(one(k))
        off = max(off, abs(g(i,k) - one(k))/by)
      end do
    end do
    k = 1 + mod(way, n)   ! other places, and beside one that is bad
    call NAME_evt_w(cshift(t, k), cshift(x, k), cshift(v, k), c, h, flags, n, n)
    h = cshift(h, -k); flags = cshift(flags, -k)
    same = same .and. all(flags == info) .and. alike(g, h)
    x(k,1) = -2d300
    call NAME_evt_w(t, x, v, c, h, flags, n, n)
    same = same .and. flags(k) == 9
    flags(k) = info(k); h(k,:) = g(k,:)
    same = same .and. all(flags == info) .and. alike(g, h)
  end do
  print '(a,es9.1,a,i5,a)', 'off ', off, ' good ', good, merge(' same', ' else', same)
contains
  logical function alike(a, b)
    double precision, intent(in) :: a(:,:), b(:,:)
    integer :: i
    alike = .true.
    do i = 1, n
      if (info(i) == 0) alike = alike .and. all(transfer(a(i,:), [0_8]) == transfer(b(i,:), [0_8]))
    end do
  end function
end program
F

# columns NAME ARRAY: of an argument of EVT_W; 0 where it has none
columns() {
  sed -n '/_EVT_W(/,/^      END/p' "$1.f" | tr -d '\n' | grep -o "[ ,]$2(LDK,[0-9]*)" | head -n 1 |
    sed 's/.*,\([0-9]*\))/\1/' | grep . || echo 0
}

gfortran -O2 $native -fopenmp-simd -c "$root"/share/fortran/*/gs*.f \
  "$root"/share/fortran/solve/plain/*.f 2>>log
flags='-O3 -fno-tree-slp-vectorize -fopenmp-simd -frecursive'
while read -r name ports; do
  [ -s "$name.f" ] || { echo "not ok $name is derived"; continue; }
  sed "s/NAME/$name/g; s/NPAR/$(size "$name" npar)/g; s/NCST/$(size "$name" ncst)/g
    s/= NX/= $(columns "$name" X)/; s/= NV/= $(columns "$name" V)/
    s/= NE/= $(columns "$name" GV)/
    s/= PORTS/= $ports/" beside.f90 >main.f90
  routines "$name" "$name.f" EVT_W >lanes.f
  for march in $processors; do
    vectorizer lanes.f $flags $march && vectorized EVT_W lanes.f
    told $? "$name: EVT_W is vectorized, $march" report
  done
  gfortran $flags $native -c "$name.f" >>log 2>&1
  gfortran -O1 -ffree-line-length-none -o beside main.f90 "$name.o" gs*.o >>log 2>&1 &&
    ./beside >values
  told $? "$name: the program runs" log
  awk -v name="$name" '
    function tell(good, what) { print (good ? "ok " : "not ok ") name ": " what }
    { tell($2 <= 1e-9, "EVT_W is EVT, to " $2)
      tell($4 >= 200, "of 3200 states in vectors: " $4)
      tell($5 == "same", "the same bits at every place, bad ones are left to the caller") }' values
done <<'SCENES'
event_joint 4
event_crank 2
lane_events 2
lane_event_loop 0
lane_event_pull 0
user_section 0
SCENES

check 'one that is too long has no EVT_W' fails grep -q '_EVT_W(' none/user_section.f
check 'and gsmbp_fortran says so' grep -q \
  'gsmbp: user_section: events of lanes run by run: EVT is too long to be vectorized' log
check 'a scene without events has none' fails grep -q '_EVT_W' bare.f
