# Batches: the compiler vectorizes the loops over the states; GSSCV and GSSC, the sines and
# cosines, against quad precision. Needs the scenes derived (tests/run does that).
. tests/tools/check.sh
. tests/tools/loops.sh
functions=$PWD/share/fortran/functions
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit

emitted=$GSMBP_TEST_DIR/fortran_out

for scene in batch_arm batch_bars batch_stop; do
  file=$emitted/$scene.f
  routines $scene "$file" 'INV_V MAS_V BIA_V FWD_V RHS_V' >batches.f
  for march in $processors; do
    vectorizer batches.f -O3 $march -frecursive
    for routine in INV MAS BIA FWD RHS; do
      vectorized "${routine}_V" batches.f
      told $? "$scene: ${routine}_V is vectorized, $march" report
    done
  done
  [ -s "$file" ] && ! grep -q 'One state after the other' "$file"
  told $? "$scene: nothing state by state"
done
for march in $processors; do
  vectorizer "$functions/gsscv.f" -O2 $march && grep -q 'loop vectorized' report
  told $? "GSSCV is vectorized, $march" report
done

# errors in units of the last place of the result: angles of either sign up to a size, then the
# numbers next to multiples of pi/2, where all digits of pi count
cat >sines.f90 <<'F'
program sines
  implicit none
  integer, parameter :: n = 20000
  real(8) :: x(8,n), s(8,n), c(8,n), worst, half
  real(8) :: size(8) = [0.7d0, 4d0, 1d2, 1d4, 1d5, 1.1d5, 1d9, 1d22]
  integer :: i, k, j, near, way
  call random_seed(size = k)
  call random_seed(put = [(7919*i, i = 1, k)])
  half = acos(-1d0)/2
  do way = 0, 3
    near = mod(way, 2)
    do k = 1, 8
      call random_number(x)
      x = size(k)*(2*x - 1)
      if (near == 1) x = anint(x/half)*half
      if (way < 2) then
        call gsscv(n, x, s, c)
      else
        do j = 1, n
          do i = 1, 8
            call gssc(x(i,j), s(i,j), c(i,j))
          end do
        end do
      end if
      worst = 0
      do j = 1, n
        worst = max(worst, maxval(off(s(:,j), sin(real(x(:,j), 16)))), &
                    maxval(off(c(:,j), cos(real(x(:,j), 16)))))
      end do
      print '(es8.1,i2,f8.3,a)', size(k), near, worst, merge(' GSSCV', ' GSSC ', way < 2)
    end do
  end do
  x(:,1) = [0d0, 0.5d0, 1d0, half, -half, 1d-300, -2d0, 1d5]
  call gsscv(1, x, s, c)
  print '(a,l2)', 'zeros', s(1,1) == 0 .and. c(1,1) == 1 .and. s(6,1) == x(6,1)
  x(3,1) = 1/(x(1,1)*0)
  call gsscv(1, x, s, c)
  print '(a,l2)', 'others', c(1,1) == 1 .and. s(3,1) /= s(3,1) &
    .and. abs(s(7,1) - sin(-2d0)) < 1d-15
  call gssc(-0d0, s(1,1), c(1,1))
  call gssc(x(3,1), s(3,1), c(3,1))
  call gssc(x(6,1), s(6,1), c(6,1))
  print '(a,l2)', 'one_angle', s(1,1) == 0 .and. c(1,1) == 1 &
    .and. s(3,1) /= s(3,1) .and. c(3,1) /= c(3,1) .and. s(6,1) == x(6,1)
contains
  elemental real(8) function off(x, y)
    real(8), intent(in) :: x
    real(16), intent(in) :: y
    off = real(abs(x - y)/max(spacing(abs(real(y, 8))), tiny(1d0)), 8)
  end function
end program
F
gfortran -O2 $native -fopenmp-simd -c "$functions"/gssc*.f &&
  gfortran -O1 -o sines sines.f90 gsscv.o gssc.o gsscl.o && ./sines >values ||
  echo 'not ok the program runs'
awk 'NF == 4 {
    printf "%s %s: sines and cosines up to %s rad%s: ", $3 < 1 ? "ok" : "not ok", $4, $1,
      $2 ? " at multiples of pi/2" : ""
    print "error " $3 " units (below 1)"
  }
  NF == 2 { print ($2 == "T" ? "ok" : "not ok") " " $1 }' values
check 'all ranges' test "$(wc -l <values)" -eq 35
