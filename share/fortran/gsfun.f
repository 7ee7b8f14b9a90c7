      SUBROUTINE GSFUN( RHS, CMD, CLO, VIN, T, SIDE, X, NU, NX, NV, IP,
     $                  RP, CST, V, XD, W, ISTAT, INFO )
C
C     PURPOSE
C     The right-hand side under its inputs: V by GSINP, XD by RHS.
C
C     ARGUMENTS
C     As GSINP; RHS (external) is <NAME>_RHS, and
C     V       (input/output) DOUBLE PRECISION array, dimension (NV):
C             kept where it is constant (IP(1) = IP(2) = 0).
C     XD      (output) DOUBLE PRECISION array, dimension (NX).
C     ISTAT   (input/output) INTEGER array, GSSIM's statistics: entry 1
C             counts the calls, entry 8 those where the constraints lost
C             rank (RHS returned 2: its result is usable, multipliers
C             are not unique); on failure entry 6 is the INFO of the
C             routine that failed and entry 7 names it: 1 the inputs,
C             2 RHS.
C     INFO    (output) INTEGER, 0 or the INFO of what failed.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CMD, CLO, VIN
      INTEGER            SIDE, NU, NX, NV, IP(*), ISTAT(*), INFO
      DOUBLE PRECISION   T, X(*), RP(*), CST(*), V(*), XD(*), W(*)
C
      INFO = 0
      IF ( IP(1).NE.0 .OR. IP(2).NE.0 ) THEN
         CALL GSINP( CMD, CLO, VIN, T, SIDE, X, NU, NX, NV, IP, RP, CST,
     $               V, W, INFO )
         IF ( INFO.NE.0 ) THEN
            ISTAT(6) = INFO
            ISTAT(7) = 1
            RETURN
         END IF
      END IF
      CALL RHS( T, X, V, CST, XD, INFO )
      ISTAT(1) = ISTAT(1) + 1
      IF ( INFO.EQ.2 ) THEN
         ISTAT(8) = ISTAT(8) + 1
         INFO = 0
      ELSE IF ( INFO.NE.0 ) THEN
         ISTAT(6) = INFO
         ISTAT(7) = 2
      END IF
      END
