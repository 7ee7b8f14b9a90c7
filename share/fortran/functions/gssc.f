      SUBROUTINE GSSC( X, S, C )
C
C     PURPOSE
C     Sine and cosine of an angle.
C
C     ARGUMENTS
C     X       (input) DOUBLE PRECISION, angle [rad].
C     S       (output) DOUBLE PRECISION, its sine.
C     C       (output) DOUBLE PRECISION, its cosine.
C
C     METHOD
C     That of GSSCV, for one angle: X = F*pi/2 + Y + E, polynomials in
C     Y, and the quadrant says which of sine, cosine and their
C     opposites are asked for; without branches, that a processor would
C     have to foresee. The error is below one unit in the last place.
C     Beyond |X| = 1D5, where X is no number, and in a precision beyond
C     double, GSSCL does it with SIN and COS.
C
C     REFERENCES
C     FDLIBM 5.3 (Sun Microsystems, 1993): e_rem_pio2.c, k_sin.c,
C     k_cos.c: the parts of pi/2 and the polynomials.
C
      IMPLICIT NONE
      INTEGER            K
      DOUBLE PRECISION   X, S, C, BIG, ROUND, TWOPI, MORE, P1, P2, P3,
     $                   S1, S2, S3, S4, S5, S6, C1, C2, C3, C4, C5, C6,
     $                   F, R, W, Y, E, Z, OUT(0:4)
      PARAMETER          ( BIG = 1.0D5, ROUND = 6755399441055744.0D0,
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
      EXTERNAL           GSSCL
      IF ( .NOT.( ABS(X).LE.BIG ) .OR. MORE.GT.1.0D0 ) THEN
         CALL GSSCL( X, S, C )
         RETURN
      END IF
      F = ( X*TWOPI + ROUND ) - ROUND
      K = IAND( INT( F ), 3 )
      R = X - F*P1
      W = F*P2
      Y = R - W
      E = ( ( R - Y ) - W ) - F*P3
      Z = Y*Y
      W = 0.5D0*Z
      R = 1.0D0 - W
      OUT(0) = Y + ( E + Z*( Y*( S1 + Z*( S2 + Z*( S3 + Z*( S4
     $         + Z*( S5 + Z*S6 ) ) ) ) ) - 0.5D0*E ) )
      OUT(1) = R + ( ( ( 1.0D0 - R ) - W ) + ( Z*Z*( C1 + Z*( C2
     $         + Z*( C3 + Z*( C4 + Z*( C5 + Z*C6 ) ) ) ) ) - Y*E ) )
      OUT(2) = -OUT(0)
      OUT(3) = -OUT(1)
      OUT(4) = OUT(0)
      S = OUT(K)
      C = OUT(K+1)
      END
