      SUBROUTINE GSDBEG( PRJ, SIZ, CST, NB, TB, NT, TOUT, X, XOUT, W,
     $                   ISTAT, INFO )
C
C     PURPOSE
C     The start of a run: whether the driver can run this scene, whether
C     the arguments are good, whether X is on the constraints.
C
C     ARGUMENTS
C     PRJ, SIZ, CST, NB, TB, NT, TOUT, X, ISTAT, INFO  as GSRUN8.
C     XOUT    (output) DOUBLE PRECISION array, dimension (NX): X, on the
C             constraints to rounding.
C     W       (workspace) DOUBLE PRECISION array, dimension (NX).
C
      IMPLICIT NONE
      EXTERNAL           PRJ
      INTEGER            SIZ(12), NB, NT, ISTAT(6), INFO
      DOUBLE PRECISION   CST(*), TB(*), TOUT(*), X(*), XOUT(*), W(*)
      INTEGER            GSFIN
      EXTERNAL           GSDMOV, GSFIN
      DOUBLE PRECISION   NEAR(2)
      INTEGER            I
C
      DO 10 I = 1, 6
         ISTAT(I) = 0
   10 CONTINUE
      ISTAT(5) = -1
C
C     -- what this driver cannot do
      DO 20 I = 1, 3
         INFO = I
         IF ( SIZ(9+I).NE.0 ) RETURN
   20 CONTINUE
      INFO = -6
      IF ( NB.LT.0 ) RETURN
      INFO = 4
      IF ( NB.LT.SIZ(9) ) RETURN
C
C     -- arguments
      INFO = -4
      IF ( SIZ(3).LT.1 .OR. SIZ(3).LT.SIZ(1) + SIZ(2) ) RETURN
      INFO = -7
      IF ( GSFIN( NB, TB ).NE.0 ) RETURN
      INFO = -8
      IF ( NT.LT.1 ) RETURN
      INFO = -9
      IF ( GSFIN( NT, TOUT ).NE.0 ) RETURN
      DO 30 I = 2, NT
         IF ( TOUT(I).LE.TOUT(I-1) ) RETURN
   30 CONTINUE
      INFO = -10
      IF ( GSFIN( SIZ(3), X ).NE.0 ) RETURN
C
C     -- onto the constraints, if they are as near as rounding of a
C        printed state leaves them
      NEAR(1) = 1.0D0
      DO 40 I = 1, SIZ(3)
         XOUT(I) = X(I)
   40 CONTINUE
      DO 50 I = 1, SIZ(1) + SIZ(2)
         NEAR(1) = MAX( NEAR(1), ABS( X(I) ) )
   50 CONTINUE
      NEAR(1) = 1.0D-6*NEAR(1)
      NEAR(2) = NEAR(1)
      CALL GSDMOV( PRJ, SIZ, TOUT(1), CST, NEAR, XOUT, W, ISTAT, INFO )
      IF ( INFO.NE.0 ) THEN
         INFO = 11
         RETURN
      END IF
      DO 60 I = 1, SIZ(3)
         X(I) = XOUT(I)
   60 CONTINUE
      ISTAT(4) = 0
      ISTAT(6) = 1
      END
      SUBROUTINE GSDSTP( NB, TB, T, TE, TZ, SIDE )
C
C     PURPOSE
C     Where steps from T have to end: the first of the times TB after T,
C     or TE.
C
C     ARGUMENTS
C     NB, TB  (input) as GSRUN8.
C     T       (input) DOUBLE PRECISION, the time [s].
C     TE      (input) DOUBLE PRECISION, the latest end, after T [s].
C     TZ      (output) DOUBLE PRECISION, the end [s].
C     SIDE    (output) INTEGER, -1 if it is one of TB, else 1.
C
      IMPLICIT NONE
      INTEGER            NB, SIDE
      DOUBLE PRECISION   TB(*), T, TE, TZ
      INTEGER            I
C
      TZ   = TE
      SIDE = 1
      DO 10 I = 1, NB
         IF ( TB(I).GT.T .AND. TB(I).LE.TZ ) THEN
            TZ   = TB(I)
            SIDE = -1
         END IF
   10 CONTINUE
      END
