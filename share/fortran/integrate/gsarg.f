      SUBROUTINE GSARG( NQ, NU, NX, NV, NLAM, T0, X0, NT, TOUT, NB,
     $                  TBRK, IOPT, ROPT, ATOL, R, LDX, LDV, LW, INFO )
C
C     PURPOSE
C     Are the arguments of GSSIM within their ranges?  R is IP(4); INFO
C     is 0, or -i for the argument i of GSSIM.
C
      IMPLICIT NONE
      INTEGER            NQ, NU, NX, NV, NLAM, NT, NB, IOPT(*), R, LDX,
     $                   LDV, LW, INFO
      DOUBLE PRECISION   T0, X0(*), TOUT(*), TBRK(*), ROPT(*), ATOL(*)
      INTEGER            GSFIN, I
      EXTERNAL           GSFIN
C
C     -- sizes
      INFO = 0
      IF ( NQ.LT.0 ) INFO = -8
      IF ( NU.LT.0 ) INFO = -9
      IF ( NX.LT.MAX( 1, NQ + NU ) ) INFO = -10
      IF ( NV.LT.0 ) INFO = -11
      IF ( NLAM.LT.0 ) INFO = -12
      IF ( NT.LT.1 ) INFO = -15
      IF ( NB.LT.0 ) INFO = -17
      IF ( LDX.LT.NX ) INFO = -26
      IF ( LDV.LT.MAX( 1, NV ) ) INFO = -28
      I = 2*NU*( R + 1 ) + 24*NX + NV*NX + 2*NV + 8*NU + 10*NQ + 7*NLAM
     $    + 3*NLAM*NU
      IF ( LW.LT.I + 60 ) INFO = -32
      IF ( INFO.NE.0 ) RETURN
C
C     -- numbers and options
      IF ( .NOT.( ABS( T0 ).LE.1.0D300 ) ) INFO = -13
      IF ( GSFIN( NX, X0 ).NE.0 ) INFO = -14
      IF ( GSFIN( NT, TOUT ).NE.0 ) INFO = -16
      IF ( GSFIN( NB, TBRK ).NE.0 ) INFO = -18
      IF ( IOPT(1).NE.4 .AND. IOPT(1).NE.8 .AND. IOPT(1).NE.9 )
     $   INFO = -19
      IF ( IOPT(2).LT.1 .OR. IOPT(2).GT.6 ) INFO = -19
      IF ( IOPT(1).EQ.4 .AND. .NOT.( ROPT(1).GT.0.0D0 ) ) INFO = -20
      IF ( IOPT(1).GE.8 .AND. .NOT.( ROPT(2).GT.0.0D0 .AND.
     $     ROPT(1).GE.0.0D0 .AND. ROPT(3).GE.0.0D0 ) ) INFO = -20
      IF ( INFO.NE.0 ) RETURN
C
C     -- times and tolerances
      IF ( IOPT(1).EQ.4 .AND. ( TOUT(NT) - T0 )/ROPT(1).GT.2.0D9 )
     $   INFO = -20
      IF ( TOUT(1).LT.T0 ) INFO = -16
      DO 10 I = 2, NT
         IF ( TOUT(I).LE.TOUT(I-1) ) INFO = -16
   10 CONTINUE
      DO 20 I = 2, NB
         IF ( TBRK(I).LE.TBRK(I-1) ) INFO = -18
   20 CONTINUE
      IF ( IOPT(1).GE.8 ) THEN
         DO 30 I = 1, NX
            IF ( .NOT.( ATOL(I).GE.0.0D0 ) ) INFO = -21
   30    CONTINUE
      END IF
      END
