      SUBROUTINE GSSTO( OUT, CTL, CMD, CLO, VIN, EVT, RST, METHOD, T, X,
     $                  SIZ, TIM, IP, RP, CST, V, W, XOUT, VOUT, STP,
     $                  ISTP, ACTED, ISTAT, INFO )
C
C     PURPOSE
C     At a stop of a run: the output, the samples and events that are
C     due there, and the next stop; at its end events of the user alone
C     (GSEND).
C
C     ARGUMENTS
C     As GSSIM, and
C     METHOD  (input) INTEGER, IOPT(1).
C     T, X    (input) the time, (input/output) the state.
C     STP     (output) DOUBLE PRECISION array, dimension (3): the times
C             of (1) the next stop, (2) the next break, sample or end of
C             the run and (3) the next sample [s].
C     ISTP    (input/output) INTEGER array, dimension (3):
C             (1) on exit -1 if the next stop is a break, a sample or
C                 the end of the run, where the limits of the inputs are
C                 from the left, else 1;
C             (2) the number of the next output time, NT + 1 at the end
C                 of the run, and (3) that of the next break.
C     ACTED   (output) INTEGER, 1 if the integration starts again here.
C     INFO    (output) INTEGER, as GSSIM: 0, 3 or 11.
C
C     METHOD
C     Method 4 stops at every output time; the others at an output time
C     that is that of a sample but for rounding, and at the last one.
C
      IMPLICIT NONE
      EXTERNAL           OUT, CTL, CMD, CLO, VIN, EVT, RST
      INTEGER            METHOD, SIZ(8), IP(*), ISTP(3), ACTED,
     $                   ISTAT(*), INFO
      DOUBLE PRECISION   T, X(*), TIM(*), RP(*), CST(*), V(*), W(*),
     $                   XOUT(*), VOUT(*), STP(3)
      DOUBLE PRECISION   GSEPS, EPS, TB, TS
      EXTERNAL           GSEPS, GSDUE, GSEND, GSEVR
      INTEGER            NU, NX, NV, NT, NB, IT, IB, SIDE, I, IER
C
      NU = SIZ(2)
      NX = SIZ(3)
      NV = SIZ(4)
      NT = SIZ(6)
      NB = SIZ(7)
      IT = ISTP(2)
      IB = ISTP(3)
      INFO  = 0
      ACTED = 0
      EPS   = GSEPS()
      IF ( IT.EQ.NT .AND. T.GE.TIM(1+NT) ) THEN
         CALL GSEND( OUT, CTL, CMD, CLO, VIN, EVT, RST, T, X, NU, NX,
     $               NV, IP, RP, CST, V, W, ISTAT, IER )
         IF ( IER.NE.0 ) INFO = 3
         IF ( IP(28).GT.0 ) THEN
            IF ( IP(IP(28)+8).GT.0 .AND. INFO.EQ.0 ) INFO = 11
         END IF
         IF ( INFO.NE.0 ) RETURN
      END IF
      IF ( T.GE.TIM(1+IT) ) THEN
         DO 10 I = 1, NX
            XOUT(NX*(IT-1)+I) = X(I)
   10    CONTINUE
         DO 20 I = 1, NV
            VOUT(NV*(IT-1)+I) = V(I)
   20    CONTINUE
         ISTAT(5) = IT
         IT = IT + 1
         ISTP(2) = IT
         IF ( IT.GT.NT ) RETURN
      END IF
   30 IF ( IB.LE.NB ) THEN
         IF ( TIM(1+NT+IB).LE.T ) THEN
            IB = IB + 1
            ISTP(3) = IB
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
      IF ( IP(28).GT.0 ) THEN
         IF ( IP(IP(28)+8).GT.0 ) INFO = 11
      END IF
      IF ( IER.NE.0 ) INFO = 3
      IF ( INFO.NE.0 ) RETURN
C
C     -- the next stop
      I = NT
      IF ( METHOD.EQ.4 ) I = IT
      TB = TIM(1+I)
      SIDE = 1
      IF ( I.EQ.NT ) SIDE = -1
      IF ( IB.LE.NB ) THEN
         IF ( TIM(1+NT+IB).LE.TB ) SIDE = -1
         TB = MIN( TB, TIM(1+NT+IB) )
      END IF
      IF ( TS.LE.TB + 8.0D0*EPS*ABS( TB ) ) THEN
         SIDE = -1
         IF ( TS.LT.TB - 8.0D0*EPS*ABS( TB ) ) TB = TS
         DO 40 I = IT, NT
            IF ( TIM(1+I).GT.TS + 8.0D0*EPS*ABS( TS ) ) GO TO 50
            IF ( TIM(1+I).GE.TS - 8.0D0*EPS*ABS( TS ) ) TB = TIM(1+I)
   40    CONTINUE
   50    IF ( IB.LE.NB ) TB = MIN( TB, TIM(1+NT+IB) )
      END IF
      STP(1) = TB
      STP(2) = MIN( TIM(1+NT), TS )
      IF ( IB.LE.NB ) STP(2) = MIN( STP(2), TIM(1+NT+IB) )
      STP(3)  = TS
      ISTP(1) = SIDE
      END
