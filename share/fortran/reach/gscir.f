      SUBROUTINE GSCIR( CO, SC, RAD )
C
C     PURPOSE
C     The angles th at which
C       CO(1) cos(2 th) + CO(2) sin(2 th) + CO(3) cos(th) + CO(4) sin(th)
C       + CO(5) = 0: where a conic meets the unit circle.
C
C     ARGUMENTS
C     CO      (input) DOUBLE PRECISION array, dimension (5) [any].
C     SC      (output) DOUBLE PRECISION array, dimension (2,4): sine and
C             cosine of each angle; sine 0, cosine 1 where there is none.
C     RAD     (output) DOUBLE PRECISION array, dimension (4): -1 where
C             there is no real root; else the square of the derivative
C             beside the largest that it may have, 0 at a double root [1].
C
C     METHOD
C     The tangent of half the angle from a place where the sum is large
C     solves an equation of degree four, whose roots Aberth's iteration
C     finds together; real ones are refined by Newton's method on the sum
C     itself. A root is real where the sum is below 1D-14 of its size, of
C     several that coincide also where they are found apart by 1D-3.
C
C     REFERENCES
C     O. Aberth, Mathematics of Computation 27 (1973), 339-344.
C
C     ERROR INDICATOR
C     None: coefficients that are not finite, or all 0, have no root.
C
      IMPLICIT NONE
      DOUBLE PRECISION   CO(5), SC(2,4), RAD(4), A(0:4), ZR(4), ZI(4)
      DOUBLE PRECISION   SIZE, FAR, TH, F, FD
      INTEGER            K, I
      EXTERNAL           GSCIE, GSCIQ, GSCIF
C
      SIZE = 0.0D0
      DO 10 K = 1, 5
         SIZE = SIZE + ABS( CO(K) )
   10 CONTINUE
      DO 20 K = 1, 4
         SC(1,K) = 0.0D0
         SC(2,K) = 1.0D0
         RAD(K) = -1.0D0
   20 CONTINUE
      IF ( .NOT.( SIZE.GT.0.0D0 .AND. SIZE.LE.1.0D300 ) ) RETURN
C
      CALL GSCIQ( CO, SIZE, FAR, A )
      CALL GSCIE( A, ZR, ZI )
      DO 40 K = 1, 4
         IF ( ABS( ZI(K) ).LE.1.0D-3*( 1.0D0 + ZR(K)**2 ) ) THEN
            TH = FAR + 2.0D0*ATAN( ZR(K) )
            DO 30 I = 1, 4
               CALL GSCIF( CO, TH, F, FD )
               IF ( ABS( FD ).GT.1.0D-6*SIZE .AND.
     $              ABS( F ).LE.1.0D-3*ABS( FD ) ) TH = TH - F/FD
   30       CONTINUE
            CALL GSCIF( CO, TH, F, FD )
            IF ( ABS( F ).LE.1.0D-14*SIZE ) THEN
               SC(1,K) = SIN( TH )
               SC(2,K) = COS( TH )
               RAD(K) = ( FD/SIZE )**2
            END IF
         END IF
   40 CONTINUE
      END
C
      SUBROUTINE GSCIF( CO, TH, F, FD )
C
C     PURPOSE
C     The sum of GSCIR and its derivative at an angle.
C
C     ARGUMENTS
C     CO      (input) DOUBLE PRECISION array, dimension (5).
C     TH      (input) DOUBLE PRECISION, the angle [rad].
C     F, FD   (output) DOUBLE PRECISION, sum and derivative.
C
C     METHOD
C     Sine and cosine of the double angle by those of the angle.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   CO(5), TH, F, FD, S, C, S2, C2
C
      S = SIN( TH )
      C = COS( TH )
      S2 = 2.0D0*S*C
      C2 = ( C - S )*( C + S )
      F = CO(1)*C2 + CO(2)*S2 + CO(3)*C + CO(4)*S + CO(5)
      FD = 2.0D0*( CO(2)*C2 - CO(1)*S2 ) - CO(3)*S + CO(4)*C
      END
C
      SUBROUTINE GSCIQ( CO, SIZE, FAR, A )
C
C     PURPOSE
C     The equation of degree four of GSCIR.
C
C     ARGUMENTS
C     CO      (input) DOUBLE PRECISION array, dimension (5).
C     SIZE    (input) DOUBLE PRECISION, the sum of their sizes.
C     FAR     (output) DOUBLE PRECISION, the angle that x = 0 belongs to:
C             opposite to it the sum is large [rad].
C     A       (output) DOUBLE PRECISION array, dimension (0:4), of
C             A(0) + A(1) x + ... + A(4) x**4, x = tan((th - FAR)/2).
C
C     METHOD
C     Of sixteen places the one with the largest sum.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   CO(5), SIZE, FAR, A(0:4), TH, F, FD, BIG, PI
      DOUBLE PRECISION   P, Q, R, S, T, C1, S1, C2, S2
      INTEGER            K
      PARAMETER          ( PI = 3.1415926535897932384626433832795D0 )
      EXTERNAL           GSCIF
C
      BIG = -1.0D0
      FAR = 0.0D0
      DO 10 K = 1, 16
         TH = 0.3D0 + K*PI/8.0D0
         CALL GSCIF( CO, TH, F, FD )
         IF ( ABS( F ).GT.BIG ) THEN
            BIG = ABS( F )
            FAR = TH - PI
         END IF
   10 CONTINUE
      C1 = COS( FAR )
      S1 = SIN( FAR )
      C2 = COS( 2.0D0*FAR )
      S2 = SIN( 2.0D0*FAR )
      P = ( CO(1)*C2 + CO(2)*S2 )/SIZE
      Q = ( CO(2)*C2 - CO(1)*S2 )/SIZE
      R = ( CO(3)*C1 + CO(4)*S1 )/SIZE
      S = ( CO(4)*C1 - CO(3)*S1 )/SIZE
      T = CO(5)/SIZE
      A(0) = P + R + T
      A(1) = 4.0D0*Q + 2.0D0*S
      A(2) = 2.0D0*T - 6.0D0*P
      A(3) = 2.0D0*S - 4.0D0*Q
      A(4) = P - R + T
      END
C
      SUBROUTINE GSCIE( A, ZR, ZI )
C
C     PURPOSE
C     The four roots of A(0) + A(1) x + ... + A(4) x**4, A(4) not small.
C
C     ARGUMENTS
C     A       (input) DOUBLE PRECISION array, dimension (0:4).
C     ZR, ZI  (output) DOUBLE PRECISION arrays, dimension (4): real and
C             imaginary parts.
C
C     METHOD
C     Aberth's iteration from a circle of the size of the roots, at most
C     100 times, until no root moves by more than 1D-15 of its size.
C
C     ERROR INDICATOR
C     None.
C
      IMPLICIT NONE
      DOUBLE PRECISION   A(0:4), ZR(4), ZI(4), RING, FR, FI, GR, GI, T
      DOUBLE PRECISION   WR, WI, SR, SI, DR, DI, D, MOVED
      INTEGER            K, J, I
C
      RING = 0.0D0
      DO 10 K = 0, 3
         T = ABS( A(K)/A(4) )
         IF ( T.GT.0.0D0 ) RING = MAX( RING, T**( 1.0D0/( 4 - K ) ) )
   10 CONTINUE
      RING = MAX( RING, 1.0D-3 )
      DO 20 K = 1, 4
         ZR(K) = RING*COS( 1.5708D0*K + 0.4D0 )
         ZI(K) = RING*SIN( 1.5708D0*K + 0.4D0 )
   20 CONTINUE
      DO 60 I = 1, 100
         MOVED = 0.0D0
         DO 50 K = 1, 4
C           -- value F and derivative G by Horner's rule
            FR = A(4)
            FI = 0.0D0
            GR = 0.0D0
            GI = 0.0D0
            DO 30 J = 3, 0, -1
               T = GR*ZR(K) - GI*ZI(K) + FR
               GI = GR*ZI(K) + GI*ZR(K) + FI
               GR = T
               T = FR*ZR(K) - FI*ZI(K) + A(J)
               FI = FR*ZI(K) + FI*ZR(K)
               FR = T
   30       CONTINUE
C           -- G less F times the sum of 1/(z - other z)
            SR = 0.0D0
            SI = 0.0D0
            DO 40 J = 1, 4
               IF ( J.NE.K ) THEN
                  DR = ZR(K) - ZR(J)
                  DI = ZI(K) - ZI(J)
                  D = MAX( DR*DR + DI*DI, 1.0D-300 )
                  SR = SR + DR/D
                  SI = SI - DI/D
               END IF
   40       CONTINUE
            WR = GR - ( FR*SR - FI*SI )
            WI = GI - ( FR*SI + FI*SR )
            D = WR*WR + WI*WI
            IF ( D.GT.1.0D-290 ) THEN
               DR = ( FR*WR + FI*WI )/D
               DI = ( FI*WR - FR*WI )/D
               ZR(K) = ZR(K) - DR
               ZI(K) = ZI(K) - DI
               T = ABS( ZR(K) ) + ABS( ZI(K) ) + 1.0D-30
               MOVED = MAX( MOVED, ( ABS( DR ) + ABS( DI ) )/T )
            END IF
   50    CONTINUE
         IF ( MOVED.LE.1.0D-15 ) RETURN
   60 CONTINUE
      END
