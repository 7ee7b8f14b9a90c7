      SUBROUTINE GSPLN( NC, NP, K, BRK, COEF, T, SIDE, ND, F, LDF,
     $                  INFO )
C
C     PURPOSE
C     To evaluate NC piecewise polynomials with common breaks, and their
C     derivatives: planned motions, profiles, tables, gain schedules.
C
C     ARGUMENTS
C     NC      (input) INTEGER, the number of components, NC >= 0.
C     NP      (input) INTEGER, the number of pieces, NP >= 1.
C     K       (input) INTEGER, coefficients per piece (degree + 1).
C     BRK     (input) DOUBLE PRECISION array, dimension (NP+1), strictly
C             increasing: piece P runs from BRK(P) to BRK(P+1).
C     COEF    (input) DOUBLE PRECISION array, dimension (NC,NP,K): in
C             piece P component I is the sum over L = 1..K of
C             COEF(I,P,L)*(T - BRK(P))**(K-L), Octave's own order.
C     T       (input) DOUBLE PRECISION, the argument (time [s]).
C     SIDE    (input) INTEGER, which limit to take where T is a break:
C             < 0 from the left, else from the right.
C     ND      (input) INTEGER, the highest derivative, ND >= 0.
C     F       (output) DOUBLE PRECISION array, dimension (LDF,0:ND):
C             F(I,J) is the J-th derivative of component I.
C     LDF     (input) INTEGER, leading dimension, LDF >= MAX(1,NC).
C     INFO    (output) INTEGER, see below.
C
C     METHOD
C     Binary search, then Horner's rule for value and derivatives.
C     Before the first and after the last break the value is held and
C     the derivatives are zero.  A distance of 1D-12 of the whole range
C     does not count as outside.
C
C     ERROR INDICATOR
C     INFO = 0   T is inside;
C     INFO = 1   T is outside, the end value is held;
C     INFO = -i  argument i is out of range.
C
      IMPLICIT NONE
      INTEGER            NC, NP, K, SIDE, ND, LDF, INFO
      DOUBLE PRECISION   BRK(*), COEF(NC,NP,*), T, F(LDF,0:*)
      INTEGER            I, J, L, P, LO, HI, MID
      DOUBLE PRECISION   S, TOL, FACT
C
      INFO = 0
      IF ( NC.LT.0 ) INFO = -1
      IF ( NP.LT.1 ) INFO = -2
      IF ( K.LT.1 ) INFO = -3
      IF ( .NOT.( ABS( T ).LE.1.0D300 ) ) INFO = -6
      IF ( ND.LT.0 ) INFO = -8
      IF ( LDF.LT.MAX( 1, NC ) ) INFO = -10
      IF ( INFO.NE.0 ) RETURN
C
C     -- the piece
      TOL = 1.0D-12*( BRK(NP+1) - BRK(1) )
      IF ( T.LT.BRK(1) - TOL .OR. T.GT.BRK(NP+1) + TOL ) INFO = 1
      LO = 1
      HI = NP + 1
   10 IF ( HI - LO.GT.1 ) THEN
         MID = ( LO + HI )/2
         IF ( T.GT.BRK(MID) .OR.
     $        ( T.GE.BRK(MID) .AND. SIDE.GE.0 ) ) THEN
            LO = MID
         ELSE
            HI = MID
         END IF
         GO TO 10
      END IF
      P = LO
      S = T - BRK(P)
      IF ( INFO.EQ.1 ) S = MIN( MAX( T, BRK(1) ), BRK(NP+1) ) - BRK(P)
C
C     -- Horner
      DO 50 I = 1, NC
         F(I,0) = COEF(I,P,1)
         DO 20 J = 1, ND
            F(I,J) = 0.0D0
   20    CONTINUE
         DO 40 L = 2, K
            DO 30 J = MIN( ND, L - 1 ), 1, -1
               F(I,J) = F(I,J)*S + F(I,J-1)
   30       CONTINUE
            F(I,0) = F(I,0)*S + COEF(I,P,L)
   40    CONTINUE
   50 CONTINUE
      FACT = 1.0D0
      DO 70 J = 1, ND
         FACT = FACT*DBLE( J )
         IF ( INFO.EQ.1 ) FACT = 0.0D0
         DO 60 I = 1, NC
            F(I,J) = F(I,J)*FACT
   60    CONTINUE
   70 CONTINUE
      END
