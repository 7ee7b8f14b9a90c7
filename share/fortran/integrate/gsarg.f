      SUBROUTINE GSARG( SIZ, TIM, X0, IOPT, ROPT, R, INFO )
C
C     PURPOSE
C     Are the arguments of GSSIM within their ranges?  R is IP(4); INFO
C     is 0, -i for the argument i of GSSIM, -100-k for SIZ(k).
C
      IMPLICIT NONE
      INTEGER            SIZ(8), IOPT(*), R, INFO
      DOUBLE PRECISION   TIM(*), X0(*), ROPT(*), H
      INTEGER            GSFIN, NQ, NU, NX, NV, NLAM, NT, NB, I, LEAST
      EXTERNAL           GSFIN
C
C     -- sizes
      NQ   = SIZ(1)
      NU   = SIZ(2)
      NX   = SIZ(3)
      NV   = SIZ(4)
      NLAM = SIZ(5)
      NT   = SIZ(6)
      NB   = SIZ(7)
      INFO = 0
      DO 5 I = 1, 7
         LEAST = 0
         IF ( I.EQ.3 ) LEAST = MAX( 1, NQ + NU )
         IF ( I.EQ.6 ) LEAST = 1
         IF ( SIZ(I).LT.LEAST ) INFO = -100 - I
    5 CONTINUE
      I = 2*NU*( R + 1 ) + 24*NX + NV*NX + 2*NV + 8*NU + 10*NQ + 7*NLAM
     $    + 3*NLAM*NU
      IF ( SIZ(8).LT.I + 60 ) INFO = -108
      IF ( INFO.NE.0 ) RETURN
C
C     -- numbers and options
      IF ( GSFIN( 1 + NT + NB, TIM ).NE.0 ) INFO = -13
      IF ( GSFIN( NX, X0 ).NE.0 ) INFO = -14
      IF ( IOPT(1).NE.4 .AND. IOPT(1).NE.8 .AND. IOPT(1).NE.9 )
     $   INFO = -15
      IF ( IOPT(2).LT.1 .OR. IOPT(2).GT.6 ) INFO = -15
      IF ( IOPT(1).EQ.4 .AND. .NOT.( ROPT(1).GT.0.0D0 ) ) INFO = -16
      IF ( IOPT(1).GE.8 .AND. .NOT.( ROPT(2).GT.0.0D0 .AND.
     $     ROPT(1).GE.0.0D0 .AND. ROPT(3).GE.0.0D0 ) ) INFO = -16
      IF ( INFO.NE.0 ) RETURN
C
C     -- times and tolerances
      H = ROPT(1)
      IF ( ROPT(3).GT.0.0D0 ) H = MIN( H, ROPT(3) )
      IF ( IOPT(1).EQ.4 .AND. TIM(NT+1) - TIM(1).GT.2.0D9*H ) INFO = -16
      IF ( TIM(2).LT.TIM(1) ) INFO = -13
      DO 10 I = 3, NT + NB + 1
         IF ( I.NE.NT + 2 .AND. TIM(I).LE.TIM(I-1) ) INFO = -13
   10 CONTINUE
      IF ( IOPT(1).LT.8 ) RETURN
      DO 20 I = 4, NX + 3
         IF ( .NOT.( ROPT(I).GE.0.0D0 ) ) INFO = -16
   20 CONTINUE
      END
