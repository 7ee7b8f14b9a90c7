      SUBROUTINE GSSTO( OUT, CTL, CMD, CLO, VIN, EVT, RST, T, X, NU, NX,
     $                  NV, NT, TOUT, NB, TBRK, IP, RP, CST, V, W, XOUT,
     $                  LDX, VOUT, LDV, IT, IB, TB, TEND, TS, SIDE,
     $                  ACTED, ISTAT, INFO )
C
C     PURPOSE
C     At a stop of a run: the output, the samples and events that are
C     due there, and the next stop.
C
C     ARGUMENTS
C     As GSSIM, and
C     T, X    (input) the time and the state.
C     IT, IB  (input/output) INTEGER, numbers of the next output time,
C             NT + 1 at the end of the run, and of the next break.
C     TB      (output) DOUBLE PRECISION, the time of the next stop [s].
C     TEND    (output) DOUBLE PRECISION, the next break, sample or end
C             of the run [s].
C     TS      (output) DOUBLE PRECISION, the next sample [s].
C     SIDE    (output) INTEGER: -1 if the next stop is a break, a
C             sample or the end of the run, where the limits of the
C             inputs are from the left, else 1.
C     ACTED   (output) INTEGER, 1 if the integration starts again here.
C     INFO    (output) INTEGER, as GSSIM: 0 or 3.
C
      IMPLICIT NONE
      EXTERNAL           OUT, CTL, CMD, CLO, VIN, EVT, RST
      INTEGER            NU, NX, NV, NT, NB, IP(*), LDX, LDV, IT, IB,
     $                   SIDE, ACTED, ISTAT(*), INFO
      DOUBLE PRECISION   T, X(*), TOUT(*), TBRK(*), RP(*), CST(*), V(*),
     $                   W(*), XOUT(LDX,*), VOUT(LDV,*), TB, TEND, TS
      DOUBLE PRECISION   GSEPS, EPS
      EXTERNAL           GSEPS, GSDUE, GSEVR
      INTEGER            I, IER
C
      INFO  = 0
      ACTED = 0
      EPS   = GSEPS()
      IF ( T.GE.TOUT(IT) ) THEN
         DO 10 I = 1, NX
            XOUT(I,IT) = X(I)
   10    CONTINUE
         DO 20 I = 1, NV
            VOUT(I,IT) = V(I)
   20    CONTINUE
         ISTAT(5) = IT
         IT = IT + 1
         IF ( IT.GT.NT ) RETURN
      END IF
   30 IF ( IB.LE.NB ) THEN
         IF ( TBRK(IB).LE.T ) THEN
            IB = IB + 1
            ACTED = 1
            GO TO 30
         END IF
      END IF
C
C     -- samples; TS is the time of the next ones
      CALL GSDUE( OUT, CTL, CMD, CLO, VIN, T, X, NU, NX, NV, IP, RP,
     $            CST, V, W, ISTAT, TS, I, IER )
      IF ( IER.NE.0 ) INFO = 3
      IF ( IER.NE.0 ) RETURN
      ACTED = MAX( ACTED, I )
      CALL GSEVR( CMD, CLO, VIN, EVT, RST, T, X, NU, NX, NV, IP, RP,
     $            CST, V, W, ISTAT, -1, IER )
      IF ( IER.NE.0 ) INFO = 3
      IF ( IER.NE.0 ) RETURN
C
C     -- the next stop
      TB = TOUT(IT)
      SIDE = 1
      IF ( IT.EQ.NT ) SIDE = -1
      IF ( IB.LE.NB ) THEN
         IF ( TBRK(IB).LE.TB ) SIDE = -1
         TB = MIN( TB, TBRK(IB) )
      END IF
      IF ( TS.LE.TB + 8.0D0*EPS*ABS( TB ) ) THEN
         SIDE = -1
         IF ( TS.LT.TB - 8.0D0*EPS*ABS( TB ) ) TB = TS
      END IF
      TEND = MIN( TOUT(NT), TS )
      IF ( IB.LE.NB ) TEND = MIN( TEND, TBRK(IB) )
      END
