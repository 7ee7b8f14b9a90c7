# PRE_W, the constants of runs in lanes: vectorized; beside PRE in double and in quad precision, its
# errors are not larger; the bits of a set of parameters are the same at every place, whatever the
# number of sets and those beside it, also bad ones, which it leaves to the caller.
. tests/tools/check.sh
. tests/tools/loops.sh
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit
report=$work/report

# pend2 with all passes divides by a length
examples=$root/examples
systems=$root/tests/bench/systems
statements="load(\"$root/gsmbp/gsmbp.mac\")\$"
for file in "$examples/puma560/puma560" "$examples/slider_crank/slider_crank" \
  "$examples/andrews/andrews" "$examples/hooke/hooke" "$systems/puma6" "$systems/pend2"; do
  statements="$statements kill(requests)\$ load(\"$file.mac\")\$
    if scene@name = \"pend2\" then gsmbp_passes : gsmbp_all_passes\$
    gsmbp_fortran(scene, [lanes], ['directory = \"$work\"])\$"
done
# a PRE of 40 parameters that is too long, and a right-hand side; a scene without parameters
statements="$statements
  long : gsmbp_scene(\"long\", link(rod, mass = 1, inertia = [0, 0, J]),
    revolute(A, ground, rod, axis = z, coordinate = q),
    parameters = cons(J = 1*kg*m^2, makelist(concat('c, i) = i, i, 1, 40)))\$
  block([gs__batch_limit : 35], gsmbp_fortran(long, [rhs_w], ['directory = \"$work\"]))\$
  block([gs__batch_limit : 0], gsmbp_fortran(long, [rhs_w], ['directory = \"$work/none\"]))\$
  bare : gsmbp_scene(\"bare\", link(rod, mass = 1, inertia = [0, 0, 1]),
    revolute(A, ground, rod, axis = z, coordinate = q))\$
  gsmbp_fortran(bare, [lanes], ['directory = \"$work\"])\$"
"$root/share/make/maxima" "$work/log" "$statements"
told $? 'scenes with lanes' "$work/log"

cat >beside.f90 <<'F'
! NAME, NPAR, NCST are put in
module sets
  implicit none
  integer, parameter :: np = NPAR, nc = NCST, n = 16
  double precision :: par(np), p(n,np), c(n,nc), d(n,nc), one(nc)
  integer :: info(n)
contains
  subroutine all_of(p, c, info)
    double precision, intent(in) :: p(n,np)
    double precision, intent(out) :: c(n,nc)
    integer, intent(out) :: info(n)
    call NAME_pre_w(p, c, info, n, n)
  end subroutine
  ! sets by chance about that of the scene
  subroutine scattered(p)
    double precision, intent(out) :: p(n,np)
    integer :: i
    call random_number(p)
    do i = 1, n
      p(i,:) = merge(p(i,:), par*(0.9d0 + 0.2d0*p(i,:)), par == 0)
    end do
  end subroutine
  logical function same(a, b)
    double precision, intent(in) :: a(:), b(:)
    same = all(transfer(a, [0_8]) == transfer(b, [0_8]))
  end function
end module

program beside
  use sets
  implicit none
  integer :: i, k, way, bad
  real(16) :: best(nc), given(np)
  real(8) :: size(nc), many(nc), alone(nc), big(40,np), constants(40,nc)
  logical :: fine
  integer :: flags(40)
  call random_seed(size = k)
  call random_seed(put = [(7919*i, i = 1, k)])
  call NAME_par(par)
  size = 0; many = 0; alone = 0
  fine = .true.
  do way = 1, 50
    call scattered(p)
    call all_of(p, c, info)
    fine = fine .and. all(info == 0)
    do i = 1, n
      given = p(i,:)
      call qpre(given, best, k)
      call NAME_pre(p(i,:), one, k)
      size = max(size, real(abs(best), 8))
      many = max(many, real(abs(c(i,:) - best), 8))
      alone = max(alone, real(abs(one - best), 8))
    end do
  end do
  call tell('all sets are good', fine)
  print '(a,f6.2)', 'error over that of PRE', maxval(many/max(alone, epsilon(1d0)*size, tiny(1d0)))

  ! other places, and the same set at all of them
  fine = .true.
  do k = 1, n
    call all_of(cshift(p, k), d, info)
    do i = 1, n
      fine = fine .and. same(d(i,:), c(1 + mod(i - 1 + k, n),:))
    end do
    call all_of(spread(p(k,:), 1, n), d, info)
    do i = 1, n
      fine = fine .and. same(d(i,:), c(k,:))
    end do
  end do
  do k = 9, 40   ! any number of them, with a last block that overlaps
    do i = 1, k
      big(i,:) = p(1 + mod(i, n),:)
    end do
    call NAME_pre_w(big, constants, flags, k, 40)
    do i = 1, k
      fine = fine .and. same(constants(i,:), c(1 + mod(i, n),:)) .and. flags(i) == 0
    end do
  end do
  call tell('the same bits at every place', fine)

  ! bad sets: no number, too large, a length that is 0; what PRE says of them
  fine = .true.
  bad = 0
  do k = 1, np
    do way = 1, 3
      i = 1 + mod(5*k + way, n)
      call scattered(p)
      call all_of(p, c, info)
      if (way == 1) p(i,k) = sqrt(-1d0*abs(p(i,k)) - 1)
      if (way == 2) p(i,k) = -1.1d300
      if (way == 3) p(i,k) = 0
      call NAME_pre(p(i,:), one, bad)
      call all_of(p, d, info)
      fine = fine .and. (info(i) == 9 .eqv. bad /= 0) .and. (way == 3 .or. bad == -1)
      if (bad == 4) print '(a)', 'length'
      info(i) = 0
      d(i,:) = c(i,:)
      fine = fine .and. all(info == 0) .and. same(reshape(c, [n*nc]), reshape(d, [n*nc]))
    end do
  end do
  call tell('bad sets alone are left to PRE', fine)
contains
  subroutine tell(what, is)
    character(*), intent(in) :: what
    logical, intent(in) :: is
    print '(a,1x,a)', what, merge('yes', 'no ', is)
  end subroutine
end program
F
cat >quad.f <<'F'
      INTEGER FUNCTION QSFIN( N, X )
      INTEGER N
      DOUBLE PRECISION X(*)
      QSFIN = 0
      END
      SUBROUTINE QSSC( X, S, C )
      DOUBLE PRECISION X, S, C
      S = SIN(X)
      C = COS(X)
      END
F

gfortran -O2 $native -fopenmp-simd -c "$root"/share/fortran/functions/gs*.f
flags='-O3 -fno-tree-slp-vectorize -fopenmp-simd -frecursive'
for name in puma560 slider_crank andrews hooke puma6 pend2; do
  [ -s "$name.f" ] || { echo "not ok $name is derived"; continue; }
  routines "$name" "$name.f" 'PAR PRE PRE_W' >scene.f
  routines "$name" "$name.f" PRE |
    sed -E "s/[A-Z0-9_]*_PRE\(/QPRE(/; s/\bGS(FIN|SC)\b/QS\1/g" >qpre.f
  sed "s/NAME/$name/g; s/NPAR/$(size "$name" npar)/; s/NCST/$(size "$name" ncst)/" \
    beside.f90 >main.f90
  for march in $processors; do
    [ "$name" != andrews ] || break   # it has an arc tangent
    vectorizer scene.f $flags $march && vectorized PRE_W scene.f
    told $? "$name: PRE_W is vectorized, $march" report
  done
  gfortran $flags $native -c scene.f
  gfortran -O1 -freal-8-real-16 -c qpre.f quad.f && gfortran -O1 -o beside main.f90 scene.o \
    qpre.o quad.o gs*.o && ./beside >values
  told $? "$name: the program runs"
  awk -v name="$name" '
    function tell(good, what) { print (good ? "ok " : "not ok ") name ": " what }
    /^length/ { lengths++; next }
    / (yes|no)$/ { good = $NF == "yes"; sub(/ +[a-z]+$/, ""); tell(good, $0) }
    /^error/ { tell($NF <= 3, "PRE_W against quad precision, " $0 " (at most 3)") }
    END { if (name == "pend2") tell(lengths > 0, "a length that is 0") }' values
done

# where there is none
no_pre_w() { grep -q '_RHS_W(' "$1" && ! grep -q '_PRE_W' "$1"; }
check 'a PRE that is too long has no PRE_W' no_pre_w long.f
check 'and gsmbp_fortran says so' \
  grep -q 'gsmbp: long: constants of lanes run by run: PRE is too long to be vectorized' log
check 'without RHS_W there is no PRE_W' fails grep -q '_PRE_W\|_RHS_W(' none/long.f
check 'nor without parameters' no_pre_w bare.f
