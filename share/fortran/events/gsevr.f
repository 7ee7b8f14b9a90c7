      SUBROUTINE GSEVR( CMD, CLO, VIN, EVT, RST, T, X, NU, NX, NV, IP,
     $                  RP, CST, V, W, ISTAT, K, INFO )
C
C     PURPOSE
C     GSRES under the inputs of a run, from the right; nothing where the
C     scene has no events.  At the start (K = 0) of a run where a sampled
C     device acts functions of the user are marked only if they are above
C     0 just before, too (GSENB).
C
C     ARGUMENTS
C     As GSINP and GSRES, and
C     ISTAT, INFO as GSEVK.
C
      IMPLICIT NONE
      EXTERNAL           CMD, CLO, VIN, EVT, RST
      INTEGER            NU, NX, NV, IP(*), ISTAT(*), K, INFO
      DOUBLE PRECISION   T, X(*), RP(*), CST(*), V(*), W(*)
      EXTERNAL           GSENB, GSEVK, GSINP
C
      INFO = 0
      IF ( IP(28).LE.0 ) RETURN
      CALL GSINP( CMD, CLO, VIN, T, 1, X, NU, NX, NV, IP, RP, CST, V, W,
     $            INFO )
      ISTAT(6) = INFO
      ISTAT(7) = 1
      IF ( INFO.EQ.0 ) CALL GSEVK( EVT, RST, T, X, NX, IP, RP, CST, V,
     $   ISTAT, K, INFO )
      IF ( INFO.EQ.0 .AND. K.EQ.0 ) CALL GSENB( CMD, CLO, VIN, EVT, T,
     $   X, NU, NX, NV, IP, RP, CST, V, W )
      END
      SUBROUTINE GSEVK( EVT, RST, T, X, NX, IP, RP, CST, V, ISTAT, K,
     $                  INFO )
C
C     PURPOSE
C     GSRES within a run, and what is told of it.
C
C     ARGUMENTS
C     As GSRES, and
C     IP, RP  (input/output) as GSINP.
C     ISTAT   (input/output) INTEGER array, GSSIM's statistics.
C     INFO    (output) INTEGER, 0 or the INFO of what failed, which
C             ISTAT(6) and ISTAT(7) tell as well; where that is RST or
C             GSRES ISTAT(19) is the number of the event, or 0.
C
      IMPLICIT NONE
      EXTERNAL           EVT, RST, GSRES
      INTEGER            NX, IP(*), ISTAT(*), K, INFO
      DOUBLE PRECISION   T, X(*), RP(*), CST(*), V(*)
      INTEGER            JN
C
      CALL GSRES( EVT, RST, T, X, NX, V, CST, K, IP(IP(28)), RP(IP(29)),
     $            INFO )
      ISTAT(6) = INFO
      ISTAT(7) = 7
      IF ( INFO.EQ.0 ) ISTAT(7) = 0
      JN = IP(28) + 10 + 7*IP(IP(28)) + 3*IP(IP(28)+9)
      IF ( INFO.NE.0 ) ISTAT(19) = IP(JN)
      IF ( INFO.EQ.13 ) ISTAT(19) = IP(IP(28)+8)
      END
