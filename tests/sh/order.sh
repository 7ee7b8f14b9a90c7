# The steps of the driver in Fortran (share/fortran/drive) in quad precision: their orders down to
# errors of 1e-28, which only coefficients good to 30 digits give.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/order.f" <<'F'
C     y' = y*cos(t), z' = -2*t*z**2: errors at t = 1 with N and 2*N
C     steps of each method, and the order between the two
      PROGRAM ORDER
      IMPLICIT NONE
      INTEGER            N, K, I, J, IST(6), INFO
      DOUBLE PRECISION   X(2), XN(2), W(2,13), V(1), CST(1), ATOL(2),
     $                   ERR, T, H, E(2)
      EXTERNAL           RHS, GSNON
      IST(5)  = 0
      ATOL(1) = 1.0D0
      ATOL(2) = 1.0D0
      DO 50 K = 4, 8, 4
         DO 40 J = 1, 2
            N = 256*J
            H = 1.0D0/DBLE( N )
            X(1) = 1.0D0
            X(2) = 1.0D0
            DO 30 I = 1, N
               T = DBLE( I - 1 )*H
               IF ( K.EQ.4 ) THEN
                  CALL GSDST4( RHS, GSNON, T, T + H, 1, H, X, 2, 0,
     $                         CST, V, XN, W, IST, INFO )
               ELSE
                  CALL RHS( T, X, V, CST, W, INFO )
                  CALL GSDST8( RHS, GSNON, T, T + H, 1, H, X, 2, 0,
     $                         CST, 1.0D0, ATOL, V, XN, ERR, W, IST,
     $                         INFO )
               END IF
               X(1) = XN(1)
               X(2) = XN(2)
   30       CONTINUE
            E(J) = ABS( X(1) - EXP( SIN( 1.0D0 ) ) )
     $           + ABS( X(2) - 0.5D0 )
   40    CONTINUE
         PRINT '(I2,2ES12.3,F8.3)', K, E(1), E(2),
     $         LOG( E(1)/E(2) )/LOG( 2.0D0 )
   50 CONTINUE
      END
      SUBROUTINE RHS( T, X, V, CST, XD, INFO )
      IMPLICIT NONE
      INTEGER            INFO
      DOUBLE PRECISION   T, X(2), V(1), CST(1), XD(2)
      INFO = 0
      XD(1) = X(1)*COS( T )
      XD(2) = -2.0D0*T*X(2)**2
      END
F
gfortran -O0 -freal-8-real-16 -o "$work/order" "$work/order.f" share/fortran/drive/*.f \
  $(python3 tests/tools/closure.py | grep -v -e lapack -e drive | sed 's|^|share/fortran/|') \
  2>"$work/log" ||
  { echo "not ok quad build"; cat "$work/log"; exit 1; }
"$work/order" | awk '
  { order = $1 == 4 ? 4 : 8
    good = $4 > order - 0.1 && $4 < order + 0.1 && (order == 4 || $3 < 1e-24)
    printf "%s quad precision, method of order %d: ", good ? "ok" : "not ok", order
    printf "errors %s and %s, order %s\n", $2, $3, $4 }'
