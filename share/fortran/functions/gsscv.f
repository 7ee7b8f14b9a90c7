      SUBROUTINE GSSCV( N, X, S, C )
C
C     PURPOSE
C     Sines and cosines of blocks of eight angles, in a form that
C     vectorizes.
C
C     ARGUMENTS
C     N       (input) INTEGER, the number of blocks.
C     X       (input) DOUBLE PRECISION array, dimension (8,N), angles
C             [rad].
C     S       (output) DOUBLE PRECISION array, dimension (8,N), sines.
C     C       (output) DOUBLE PRECISION array, dimension (8,N), cosines.
C
C     METHOD
C     X = F*pi/2 + Y + E, |Y| <= pi/4: pi/2 is taken off in three parts,
C     the first two of 33 bits, so that F*P1 and F*P2 are exact; E is
C     what rounding left of Y. Then polynomials in Y, and the quadrant
C     F - 4*NINT( F/4 ) says which is which, with which sign. The error
C     is below one unit in the last place up to |X| = 1D5. Larger ones
C     and those that are no number, which a sum of F**2 over X(I,:)
C     shows (it is above 4D9), and in a precision beyond double all are
C     left to SIN and COS.
C
C     REFERENCES
C     FDLIBM 5.3 (Sun Microsystems, 1993): e_rem_pio2.c, k_sin.c,
C     k_cos.c: the parts of pi/2 and the polynomials.
C
      IMPLICIT NONE
      INTEGER            N, I, J
      DOUBLE PRECISION   X(8,N), S(8,N), C(8,N), BIG, ROUND, TWOPI,
     $                   MORE, P1, P2, P3, S1, S2, S3, S4, S5, S6, C1,
     $                   C2, C3, C4, C5, C6, OUT(8), F, D, R, W,
     $                   Y, E, Z, SY, CY, T
      PARAMETER          ( BIG = 4.0D9, ROUND = 6755399441055744.0D0,
     $                     TWOPI = 0.636619772367581382433D0,
     $                     MORE = 1.0D0 + 1.0D-20,
     $                     P1 = 1.5707963267341256D0,
     $                     P2 = 6.077100506303966D-11,
     $                     P3 = 2.0222662487959506D-21 )
      PARAMETER          ( S1 = -1.66666666666666324348D-01,
     $                     S2 =  8.33333333332248946124D-03,
     $                     S3 = -1.98412698298579493134D-04,
     $                     S4 =  2.75573137070700676789D-06,
     $                     S5 = -2.50507602534068634195D-08,
     $                     S6 =  1.58969099521155010221D-10,
     $                     C1 =  4.16666666666666019037D-02,
     $                     C2 = -1.38888888888741095749D-03,
     $                     C3 =  2.48015872894767294178D-05,
     $                     C4 = -2.75573143513906633035D-07,
     $                     C5 =  2.08757232129817482790D-09,
     $                     C6 = -1.13596475577881948265D-11 )
      IF ( MORE.GT.1.0D0 ) GO TO 50
C$OMP SIMD
      DO 10 I = 1, 8
         OUT(I) = 0.0D0
   10 CONTINUE
      DO 30 J = 1, N
C$OMP SIMD
         DO 20 I = 1, 8
            F = ( X(I,J)*TWOPI + ROUND ) - ROUND
            OUT(I) = OUT(I) + F*F
            R = X(I,J) - F*P1
            W = F*P2
            Y = R - W
            E = ( ( R - Y ) - W ) - F*P3
            Z = Y*Y
            W = 0.5D0*Z
            R = 1.0D0 - W
            SY = S2 + Z*( S3 + Z*( S4 + Z*( S5 + Z*S6 ) ) )
            SY = Y + ( E + Z*( Y*( S1 + Z*SY ) - 0.5D0*E ) )
            CY = C1 + Z*( C2 + Z*( C3 + Z*( C4 + Z*( C5 + Z*C6 ) ) ) )
            CY = R + ( ( ( 1.0D0 - R ) - W ) + ( Z*Z*CY - Y*E ) )
            D = F - 4.0D0*( ( 0.25D0*F + ROUND ) - ROUND )
            W = D*D
            IF ( W.GT.0.5D0 .AND. W.LT.2.0D0 ) THEN
               T  = SY
               SY = CY
               CY = T
            END IF
            IF ( W - D.GT.1.0D0 ) SY = -SY
            IF ( W + D.GT.1.0D0 ) CY = -CY
            S(I,J) = SY
            C(I,J) = CY
   20    CONTINUE
   30 CONTINUE
      DO 40 I = 1, 8
         IF ( .NOT.( OUT(I).LE.BIG ) ) GO TO 50
   40 CONTINUE
      RETURN
   50 CONTINUE
CGCC$ NOVECTOR
      DO 70 J = 1, N
CGCC$ NOVECTOR
         DO 60 I = 1, 8
            IF ( MORE.LE.1.0D0 .AND. ABS( X(I,J) ).LE.1.0D5 ) GO TO 60
            S(I,J) = SIN( X(I,J) )
            C(I,J) = COS( X(I,J) )
   60    CONTINUE
   70 CONTINUE
      END
