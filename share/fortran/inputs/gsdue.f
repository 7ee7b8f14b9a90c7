      SUBROUTINE GSDUE( OUT, CTL, CMD, CLO, VIN, T, X, NU, NX, NV, IP,
     $                  RP, CST, V, W, ISTAT, TS, ACTED, INFO )
C
C     PURPOSE
C     The sampled devices at a stop of a compiled run: what is due at T
C     happens, with the inputs from the right.
C
C     ARGUMENTS
C     OUT, CTL (external) see GSSMP.
C     CMD, CLO, VIN, T, X, NU, NX, NV, IP, RP, CST, V, W as GSINP.
C     ISTAT   (input/output) INTEGER array, GSSIM's statistics.
C     TS      (output) DOUBLE PRECISION, the next time at which a device
C             acts or gives out [s]; 2D300 if there is none.
C     ACTED   (output) INTEGER, 1 if something was due, else 0.
C     INFO    (output) INTEGER, 0 or the INFO of what failed, which
C             ISTAT(6) and ISTAT(7) tell as well.
C
      IMPLICIT NONE
      EXTERNAL           OUT, CTL, CMD, CLO, VIN
      INTEGER            NU, NX, NV, IP(*), ISTAT(*), ACTED, INFO
      DOUBLE PRECISION   T, X(*), RP(*), CST(*), V(*), W(*), TS
      DOUBLE PRECISION   GSNXT, GSEPS
      EXTERNAL           GSNXT, GSEPS, GSINP, GSSMP
C
      INFO  = 0
      ACTED = 0
      TS    = 2.0D300
      IF ( IP(26).LE.0 ) RETURN
      TS = GSNXT( NV, IP(IP(26)), RP(IP(27)) )
      IF ( TS.GT.T + 8.0D0*GSEPS()*ABS( T ) ) RETURN
      ACTED = 1
      CALL GSINP( CMD, CLO, VIN, T, 1, X, NU, NX, NV, IP, RP, CST, V, W,
     $            INFO )
      ISTAT(6) = INFO
      ISTAT(7) = 1
      IF ( INFO.NE.0 ) RETURN
      CALL GSSMP( OUT, CTL, T, X, NX, NV, CST, V, IP(IP(26)),
     $            RP(IP(27)), INFO )
      ISTAT(6) = INFO
      ISTAT(7) = 6
      IF ( INFO.NE.0 ) RETURN
      ISTAT(7) = 0
      TS = GSNXT( NV, IP(IP(26)), RP(IP(27)) )
      END
