      SUBROUTINE GSATV( N, Y, X, A )
C
C     PURPOSE
C     Angles of blocks of eight points, in a form that vectorizes.
C
C     ARGUMENTS
C     N       (input) INTEGER, the number of blocks.
C     Y       (input) DOUBLE PRECISION array, dimension (8,N).
C     X       (input) DOUBLE PRECISION array, dimension (8,N).
C     A       (output) DOUBLE PRECISION array, dimension (8,N): the angle
C             of the point (X,Y) from the axis of X, -pi to pi, with the
C             sign of Y, as ATAN2( Y, X ) [rad].
C
C     METHOD
C     With LOW and BIG, the smaller and the larger of |X| and |Y|, the
C     tangent Q is LOW/BIG, or where that is above 0.55
C     (LOW - BIG)/(LOW + BIG), of an angle that is less by pi/4; a
C     polynomial gives the angle, and the octant what is added to it: M
C     times pi/4, as two numbers, of which the first has 48 bits, so that
C     M times it is exact. The error is below 1.7 units in the last
C     place. Where BIG is not within 1D-290 and 1D300, or something is no
C     number, and in a precision beyond double, all are left to GSATL.
C     H, 0 or 1 and then -1 or 1, stands for conditions: sums in them
C     keep gfortran from vectorizing the loop without masks (AVX-512).
C
C     REFERENCES
C     The coefficients are those of the least largest error, 2**(-58.7),
C     for |Q| <= 0.55 (Remez' algorithm).
C
      IMPLICIT NONE
      INTEGER            N, I, J
      DOUBLE PRECISION   Y(8,N), X(8,N), A(8,N), MORE, PH, PL,
     $                   A0, A1, A2, A3, A4, A5, A6, A7, A8, A9, A10,
     $                   A11, A12, OUT(8), AX, AY, LOW, BIG, NUM, DEN,
     $                   M, S, Q, Z, W, E, O, H
      PARAMETER          ( MORE = 1.0D0 + 1.0D-20,
     $                     PH = 0.7853981633974456D0,
     $                     PL = 2.6951514290790595D-15 )
      PARAMETER          ( A0  =  0.33333333333333154D0,
     $                     A1  = -0.19999999999951903D0,
     $                     A2  =  0.14285714281234652D0,
     $                     A3  = -0.11111110900584631D0,
     $                     A4  =  0.09090903239258846D0,
     $                     A5  = -0.0769220276351427D0,
     $                     A6  =  0.0666538831273945D0,
     $                     A7  = -0.058714380553215734D0,
     $                     A8  =  0.05196741802164547D0,
     $                     A9  = -0.04472258418869529D0,
     $                     A10 =  0.034457396596170524D0,
     $                     A11 = -0.02013541368452217D0,
     $                     A12 =  0.006305736176752147D0 )
      EXTERNAL           GSATL
      IF ( MORE.GT.1.0D0 ) GO TO 50
C$OMP SIMD
      DO 10 I = 1, 8
         OUT(I) = 0.0D0
   10 CONTINUE
      DO 30 J = 1, N
C$OMP SIMD
         DO 20 I = 1, 8
            AX = ABS( X(I,J) )
            AY = ABS( Y(I,J) )
            LOW = AY
            BIG = AX
            M = 0.0D0
            S = 1.0D0
            IF ( AY.GT.AX ) THEN
               LOW = AX
               BIG = AY
               M = 2.0D0
               S = -1.0D0
            END IF
            E = 0.0D0
            IF ( LOW.GE.0.0D0 .AND. BIG.GE.1.0D-290 .AND.
     $           BIG.LE.1.0D300 ) E = 1.0D0
            OUT(I) = OUT(I) + E
            H = 0.5D0 - SIGN( 0.5D0, 0.55D0*BIG - LOW )
            NUM = LOW - H*BIG
            DEN = BIG + H*LOW
            M = M + H*S
            H = SIGN( 1.0D0, X(I,J) )
            M = 2.0D0 + H*( M - 2.0D0 )
            S = H*S
            Q = NUM/DEN
            Z = Q*Q
            W = Z*Z
            E = A0 + W*( A2 + W*( A4 + W*( A6 + W*( A8 + W*( A10
     $          + W*A12 ) ) ) ) )
            O = A1 + W*( A3 + W*( A5 + W*( A7 + W*( A9 + W*A11 ) ) ) )
            E = Q*( Z*( E + Z*O ) )
            A(I,J) = SIGN( M*PH + ( S*Q + ( M*PL - S*E ) ), Y(I,J) )
   20    CONTINUE
   30 CONTINUE
      DO 40 I = 1, 8
         IF ( OUT(I).LT.N ) GO TO 50
   40 CONTINUE
      RETURN
   50 CONTINUE
      DO 70 J = 1, N
         DO 60 I = 1, 8
            CALL GSATL( Y(I,J), X(I,J), A(I,J) )
   60    CONTINUE
   70 CONTINUE
      END
