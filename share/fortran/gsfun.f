      SUBROUTINE GSFUN( RHS, CON, KIN, CMD, CLO, VIN, T, SIDE, X, NQ,
     $                  NU, NX, NV, NLAM, IP, RP, CST, V, XD, W, P,
     $                  ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     The right-hand side under its inputs: V by GSINP, XD by RHS.
C
C     ARGUMENTS
C     As GSINP; RHS (external) is <NAME>_RHS, and
C     CON, KIN (external) see GSPRT, called if P(1) > 0.
C     X       (input/output) DOUBLE PRECISION array, dimension (NX): if
C             P(1) > 0 its dependent speeds, and if P(1) > 1 its
C             dependent coordinates as well, are completed first.
C     NQ, NLAM (input) INTEGER, the numbers of coordinates and of
C             constraints.
C     V       (input/output) DOUBLE PRECISION array, dimension (NV):
C             kept where it is constant (IP(1) = IP(2) = 0).
C     XD      (output) DOUBLE PRECISION array, dimension (NX).
C     P       (input/output) DOUBLE PRECISION array, the partition, see
C             GSPRT.
C     ISTAT   (input/output) INTEGER array, GSSIM's statistics: entry 1
C             counts the calls, entry 8 those where the constraints lost
C             rank (RHS returned 2: its result is usable, multipliers
C             are not unique), entry 9 those close to a singularity of
C             orientation angles (RHS returned 3); on failure entry 6 is
C             the INFO of the routine that failed and entry 7 names it:
C             1 the inputs, 2 RHS, 5 the partition.
C     RSTAT   (input/output) DOUBLE PRECISION array, GSSIM's statistics:
C             10 and 11 the first and the last time of the calls in
C             ISTAT(8), 12 and 13 of those in ISTAT(9).
C     INFO    (output) INTEGER, 0 or the INFO of what failed.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            SIDE, NQ, NU, NX, NV, NLAM, IP(*), ISTAT(*),
     $                   INFO
      DOUBLE PRECISION   T, X(*), RP(*), CST(*), V(*), XD(*), W(*),
     $                   P(*), RSTAT(*)
      EXTERNAL           GSFUT
C
      CALL GSFUT( RHS, CON, KIN, CMD, CLO, VIN, T, T, SIDE, X, NQ, NU,
     $            NX, NV, NLAM, IP, RP, CST, V, XD, W, P, ISTAT, RSTAT,
     $            INFO )
      END
      SUBROUTINE GSFUT( RHS, CON, KIN, CMD, CLO, VIN, T, TV, SIDE, X,
     $                  NQ, NU, NX, NV, NLAM, IP, RP, CST, V, XD, W, P,
     $                  ISTAT, RSTAT, INFO )
C
C     PURPOSE
C     GSFUN with the inputs of the time TV: the stages of GSPSG that lie
C     beyond a jump of the inputs have those before it.
C
      IMPLICIT NONE
      EXTERNAL           RHS, CON, KIN, CMD, CLO, VIN
      INTEGER            SIDE, NQ, NU, NX, NV, NLAM, IP(*), ISTAT(*),
     $                   INFO
      DOUBLE PRECISION   T, TV, X(*), RP(*), CST(*), V(*), XD(*), W(*),
     $                   P(*), RSTAT(*)
      EXTERNAL           GSINP, GSPRT
      INTEGER            K
C
      INFO = 0
      IF ( P(1).GT.0.0D0 ) THEN
         CALL GSPRT( CON, KIN, T, X, NQ, NU, NLAM, CST, P, INFO )
         IF ( INFO.NE.0 ) THEN
            ISTAT(6) = INFO
            ISTAT(7) = 5
            RETURN
         END IF
      END IF
      IF ( IP(1).NE.0 .OR. IP(2).NE.0 ) THEN
         CALL GSINP( CMD, CLO, VIN, TV, SIDE, X, NU, NX, NV, IP, RP,
     $               CST, V, W, INFO )
         IF ( INFO.NE.0 ) THEN
            ISTAT(6) = INFO
            ISTAT(7) = 1
            RETURN
         END IF
      END IF
      CALL RHS( T, X, V, CST, XD, INFO )
      ISTAT(1) = ISTAT(1) + 1
      IF ( INFO.EQ.2 .OR. INFO.EQ.3 ) THEN
         K = INFO + 6
         IF ( ISTAT(K).EQ.0 ) RSTAT(2*K-6) = T
         RSTAT(2*K-5) = T
         ISTAT(K) = ISTAT(K) + 1
         INFO = 0
      ELSE IF ( INFO.NE.0 ) THEN
         ISTAT(6) = INFO
         ISTAT(7) = 2
      END IF
      END
