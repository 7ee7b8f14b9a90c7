# GSATV against ATAN2 of quad precision: in all directions, of all sizes, near the axes and near
# where its ways meet, error below 1.7 units of the last place; zeros of either sign, infinite
# numbers and what is no number as ATAN2 has them; plain, in vectors and without contractions.
. tests/tools/check.sh
. tests/tools/loops.sh
functions=$PWD/share/fortran/functions
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
cat >arcs.f90 <<'F'
program arcs
  use, intrinsic :: ieee_arithmetic
  implicit none
  integer, parameter :: n = 20000
  real(8) :: x(8,n), y(8,n), a(8,n), t(8,n), s(8,n), odd(14), worst, pi
  integer :: way, i, j
  logical :: good
  call random_seed(size = i)
  call random_seed(put = [(7919*j, j = 1, i)])
  pi = acos(-1d0)
  do way = 1, 8
    call random_number(t)
    call random_number(s)
    t = pi*(2*t - 1)
    x = cos(t)
    y = sin(t)
    select case (way)
    case (2); x = 10**(280*(2*s - 1))*x; y = 10**(280*(1 - 2*s))*y
    case (3); y = y*10**(-18*s)
    case (4); x = x*10**(-18*s)
    case (5); x = 1; y = sign(0.45d0 + 0.2d0*s, y)
    case (6); y = sign(1d0, y); x = sign(0.549d0 + 0.002d0*s, x)
    case (7); x = sign(1d0, x); y = 1 + 1d-3*(s - 0.5d0)
    case (8); x = 10**(2*s)*x; y = y*1d-310
    end select
    call gsatv(n, y, x, a)
    worst = 0
    do j = 1, n
      worst = max(worst, maxval(off(a(:,j), atan2(real(y(:,j), 16), real(x(:,j), 16)))))
    end do
    print '(a,i2,f8.3)', 'way', way, worst
  end do
  odd = [0d0, -0d0, 1d0, -1d0, 5d-324, -5d-324, 1d-300, -1d-300, 1d300, -1d308, 1d308, &
         ieee_value(1d0, ieee_positive_inf), ieee_value(1d0, ieee_negative_inf), &
         ieee_value(1d0, ieee_quiet_nan)]
  good = .true.
  do i = 1, 14
    do j = 1, 14
      y(:,1) = [0.3d0, odd(i), -0.3d0, 1d0, 2d0, -2d0, 0d0, -0d0]
      x(:,1) = [0.4d0, odd(j), 0.4d0, -3d0, 1d0, -1d0, -1d0, -1d0]
      call gsatv(1, y, x, a)
      if (.not. all(same(a(:,1), atan2(y(:,1), x(:,1))))) then
        good = .false.
        print '(a,2es12.4)', 'differs at', odd(i), odd(j)
      end if
    end do
  end do
  print '(a,l2)', 'odd ones', good
contains
  elemental real(8) function off(x, y)
    real(8), intent(in) :: x
    real(16), intent(in) :: y
    off = real(abs(x - y)/max(spacing(abs(real(y, 8))), 5d-324), 8)
  end function
  elemental logical function same(x, y)
    real(8), intent(in) :: x, y
    if (x /= x .or. y /= y) then
      same = x /= x .and. y /= y
    else
      same = sign(1d0, x) == sign(1d0, y) .and. abs(x - y) <= 2*spacing(y)
    end if
  end function
end program
F
for march in $processors; do
  vectorizer "$functions/gsatv.f" -O2 $march && grep -q 'loop vectorized' report
  told $? "GSATV is vectorized, $march" report
done
for flags in '-O3' "-O3 $native" "-O3 $native -ffp-contract=off -fopenmp-simd"; do
  gfortran $flags -c "$functions/gsatv.f" "$functions/gsatl.f" >report 2>&1 &&
    gfortran -O1 -o arcs arcs.f90 gsatv.o gsatl.o && ./arcs >values
  told $? "$flags: the program runs" report
  awk -v flags="$flags" '
    $1 == "way" {
      print ($3 < 1.7 ? "ok" : "not ok") " " flags ", way " $2 ": error " $3 " units (below 1.7)" }
    $1 == "odd" { print ($3 == "T" ? "ok" : "not ok") " " flags ", zeros, sizes, no numbers" }
    $1 == "differs" { print "   " $0 }' values
  check "$flags: all ranges" test "$(grep -c . values)" -eq 9
done
